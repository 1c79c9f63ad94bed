"""Decoys' evidence: all of the like covers vanish."""

from probe.episodes.evidence import OracleRule, TableSight
from probe.tasks.task import Task


def _covers(task: Task, sight: TableSight) -> set[int]:
    if task.cover is None:
        return set()
    like = task.scene[task.cover].object_id
    return {placed.instance for placed in task.scene.objects if placed.object_id == like}


ORACLE_VIEW = OracleRule(_covers)
