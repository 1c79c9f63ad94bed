"""Small tasks that tests make by hand."""

from __future__ import annotations

from dataclasses import replace

from probe.scene.scene import PlacedObject, Scene
from probe.scene.visibility import Visibility
from probe.tasks.task import Certificate, Letter, Option, Task
from probe.types import Pose

SCENE = Scene(
    7,
    "oak_planks",
    (
        PlacedObject(1, "proc_red_mug", Pose((0.1, 0.0, 0.0), (0.0, 1.0, 0.0, 0.0))),
        PlacedObject(2, "proc_lime", Pose((0.1, 1 / 3, 0.02))),
        PlacedObject(3, "proc_lemon", Pose((-0.1, 0.05, 0.02))),
    ),
)

FIND = Task(
    id="find-0123abcd",
    question_type="find",
    form="plain",
    seed=7,
    subject="",
    question="Which of these is on the table? Leave it on the table and point at it.",
    options=(
        Option("A", "plum"),
        Option("B", "lime"),
        Option("C", "white egg"),
        Option("D", "walnut"),
        Option("E", "None of the above"),
    ),
    answer="B",
    scene=SCENE,
    targets=(2,),
    cover=None,
    named=(),
    marks=(),
    certificate=Certificate({2: Visibility(10, 900)}, {"visible_share": 1 / 90}, ("proc_lime",)),
)


def with_answer(letter: Letter) -> Task:
    """The same task with another right letter."""
    return replace(FIND, answer=letter)
