"""Behind's evidence: what stands in front vanishes."""

from probe.episodes.evidence import OracleRule, TableSight
from probe.tasks.task import Task


def _in_front(task: Task, sight: TableSight) -> set[int]:
    return set() if task.cover is None else {task.cover}


ORACLE_VIEW = OracleRule(_in_front)
