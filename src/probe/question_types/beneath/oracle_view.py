"""Beneath's evidence: the cover vanishes."""

from probe.episodes.evidence import OracleRule, TableSight
from probe.tasks.task import Task


def _cover(task: Task, viewpoint: TableSight) -> set[int]:
    return set() if task.cover is None else {task.cover}


ORACLE_VIEW = OracleRule(_cover)
