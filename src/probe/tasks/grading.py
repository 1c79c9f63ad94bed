"""What an answer is worth. Pure functions over plain values: no tools, no physics."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal

import numpy as np

from probe.scene.scene import Scene
from probe.scene.setup import Setup
from probe.tasks.task import Letter, Task
from probe.tasks.type_rules import rules_of
from probe.types import Array, Pose

POINT_TOLERANCE_PX = 2.0
"""How far outside the visible part a point may lie."""

FEWEST_PX = 25
"""With fewer visible pixels an object can't be pointed at."""

_BELOW_TABLE = -0.02
"""Metres; an object that is lower fell off. Its origin is its lowest point when it stands."""

MOST_MOVED = 0.05
"""Metres that a thing may move where nothing but what is named may be touched."""

Outcome = Literal[
    "right",
    "wrong",
    "unanswered",
    "no point",
    "missed",
    "lost",
    "covered",
    "not removed",
    "others removed",
    "others moved",
]
Whereabouts = Literal["table", "basket", "off the table"]


@dataclass(frozen=True)
class FinalAnswer:
    """What the agent said at the end.

    Attributes:
        letter: None if it never answered.
        point: Pixel coordinates (u, v) in the last picture it was given, or None.
    """

    letter: Letter | None
    point: tuple[float, float] | None = None


@dataclass(frozen=True, eq=False)
class LastView:
    """The last picture that the agent was given, and the table as it was then, at rest.

    Attributes:
        labels: Instance number of each pixel, shape (h, w).
        scene: Where everything was.
    """

    labels: Array
    scene: Scene


@dataclass(frozen=True)
class Score:
    """Worth of an answer.

    Attributes:
        correct: The letter is right, and in Find the point too; in Exact and Memory the
            table as well.
        letter_correct: The letter alone.
        outcome: Why.
    """

    correct: bool
    letter_correct: bool
    outcome: Outcome


def grade(task: Task, answer: FinalAnswer, last: LastView) -> Score:
    """Score an answer by the task's rules; in Find, Exact and Memory the end counts too.

    Args:
        task: What was asked.
        answer: What was answered.
        last: What the agent saw last; pictures are only taken of a table at rest.
    """
    if answer.letter is None:
        return Score(False, False, "unanswered")
    if answer.letter != task.answer:
        return Score(False, False, "wrong")
    if not looks_at_end(task, answer):
        return Score(True, True, "right")
    if rules_of(task.question_type).exact:
        outcome = _grade_table(task, last.scene)
    else:
        outcome = _grade_point(task.targets[0], answer.point, last)
    return Score(outcome == "right", True, outcome)


def looks_at_end(task: Task, answer: FinalAnswer) -> bool:
    """Whether an answer's worth depends on the last view.

    That is so of a letter that has to be pointed at, and where the table itself is graded.
    """
    rules = rules_of(task.question_type)
    pointed = rules.pointed and task.answer != "E"
    return answer.letter == task.answer and (pointed or rules.exact)


def whereabouts(pose: Pose, setup: Setup) -> Whereabouts:
    """Where an object at a pose (world_from_object) is."""
    x, y, z = pose.position
    if setup.basket.holds(x, y):
        return "basket" if z > _BELOW_TABLE else "off the table"
    beside = abs(x) > setup.table_size[0] / 2 or abs(y) > setup.table_size[1] / 2
    return "off the table" if beside or z < _BELOW_TABLE else "table"


def _grade_point(target: int, point: tuple[float, float] | None, last: LastView) -> Outcome:
    if point is None:
        return "no point"
    if whereabouts(last.scene[target].pose, last.scene.setup) != "table":
        return "lost"
    mask = last.labels == target
    if np.count_nonzero(mask) < FEWEST_PX:
        return "covered"
    return "right" if distance_px(mask, point) <= POINT_TOLERANCE_PX else "missed"


def _grade_table(task: Task, end: Scene) -> Outcome:
    """Whether what was named is in the basket, and all else on the table near where it was."""
    others = [placed for placed in task.scene.objects if placed.instance not in task.named]
    if any(whereabouts(end[number].pose, end.setup) != "basket" for number in task.named):
        return "not removed"
    if any(whereabouts(end[it.instance].pose, end.setup) != "table" for it in others):
        return "others removed"
    ways = [math.dist(it.pose.position, end[it.instance].pose.position) for it in others]
    return "others moved" if max(ways, default=0.0) > MOST_MOVED else "right"


def distance_px(mask: Array, point: tuple[float, float]) -> float:
    """Distance from (u, v) to the nearest pixel of a mask, shape (h, w); 0 inside of one.

    Pixel (row, column) is the square from (column, row) to (column + 1, row + 1). Infinite for an
    empty mask and for coordinates that are no numbers.
    """
    if not all(math.isfinite(value) for value in point):
        return math.inf
    rows, columns = np.nonzero(mask)
    beside = np.maximum(np.abs(columns + 0.5 - point[0]) - 0.5, 0)
    above = np.maximum(np.abs(rows + 0.5 - point[1]) - 0.5, 0)
    return float(np.hypot(beside, above).min(initial=math.inf))
