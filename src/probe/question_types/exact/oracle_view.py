"""Exact's evidence: what the question names vanishes."""

from probe.episodes.evidence import OracleRule, TableSight
from probe.tasks.task import Task


def _named(task: Task, sight: TableSight) -> set[int]:
    return set(task.named)


ORACLE_VIEW = OracleRule(_named)
