"""Decoys' evidence: all of the like covers vanish."""

from probe.episodes.evidence import OracleRule, TableSight
from probe.tasks.task import Task


def _covers(task: Task, sight: TableSight) -> set[int]:
    return set() if task.cover is None else set(task.scene.like(task.cover))


ORACLE_VIEW = OracleRule(_covers)
