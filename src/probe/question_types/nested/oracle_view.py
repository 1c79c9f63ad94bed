"""Nested's evidence: both covers vanish."""

from probe.episodes.evidence import OracleRule, TableSight
from probe.tasks.task import Task


def _covers(task: Task, sight: TableSight) -> set[int]:
    outer = set[int]() if task.cover is None else {task.cover}
    return outer | sight.over(set(task.targets), set(task.targets))


ORACLE_VIEW = OracleRule(_covers)
