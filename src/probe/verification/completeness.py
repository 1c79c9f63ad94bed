"""Has a task all that its type is made of? Other checks rely on it. No text, no pictures."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from probe.assets.library import Library
from probe.errors import UnknownName
from probe.scene.layout import top_camera
from probe.tasks.options import CANDIDATES
from probe.tasks.task import PAIR, QuestionType, Task


@dataclass(frozen=True)
class _Makeup:
    """What every task of a type has.

    Attributes:
        targets: How many; None for any number.
        candidates: How many its certificate lists.
        measures: Numbers that its certificate must state.
        cover: Whether it names a cover.
        named: Whether it names things to remove.
    """

    targets: int | None
    candidates: int = CANDIDATES
    measures: tuple[str, ...] = ()
    cover: bool = False
    named: bool = False


_MAKEUPS: dict[QuestionType, _Makeup] = {
    "beneath": _Makeup(1, cover=True),
    "compare": _Makeup(len(PAIR), 2 * len(PAIR), ("patch_lead",)),
    "count": _Makeup(None, measures=("clear", "hidden")),
    "find": _Makeup(1, measures=("partly",)),
    "reduce": _Makeup(1, named=True),
    "size": _Makeup(len(PAIR), len(PAIR), ("area_lead", "length_lead")),
}


def makeup_problems(task: Task, library: Library) -> Iterator[str]:
    """What a task lacks, or has too much of; other checks rely on what this lets pass."""
    makeup, proof = _MAKEUPS[task.question_type], task.certificate
    if makeup.targets not in (None, len(task.targets)):
        yield f"it has {len(task.targets)} targets, not {makeup.targets}"
    if len(proof.candidates) != makeup.candidates:
        yield f"its certificate lists {len(proof.candidates)} candidates, not {makeup.candidates}"
    if missing := [name for name in makeup.measures if name not in proof.measures]:
        yield f"its certificate doesn't state {', '.join(missing)}"
    if strange := set(proof.visibility) - {placed.instance for placed in task.scene.objects}:
        yield f"its certificate measures objects {sorted(strange)}, which aren't there"
    if (task.cover is not None) != makeup.cover or bool(task.named) != makeup.named:
        yield f"what it names isn't what {task.question_type} names"
    yield from _marks(task, paired=makeup.targets == len(PAIR))
    unknown = list(_unknown(task, library))
    yield from unknown
    if task.question_type == "compare" and not unknown:
        yield from _compare(task, library)


def _unknown(task: Task, library: Library) -> Iterator[str]:
    listed = () if task.question_type == "count" else task.certificate.candidates
    for object_id in (*(placed.object_id for placed in task.scene.objects), *listed):
        try:
            library[object_id]
        except UnknownName:
            yield f"the catalogue has no {object_id!r}"


def _compare(task: Task, library: Library) -> Iterator[str]:
    """Whether its twins could be twins, and what it compares with is there."""
    for mark, twin in zip(task.marks, task.certificate.candidates[len(PAIR) :], strict=False):
        one, other = library[task.scene[mark.instance].object_id], library[twin]
        if (one.category, one.size, one.mass) != (other.category, other.size, other.mass):
            yield f"{one.id} and {twin} aren't of one shape"
    if task.form == "like":
        called = instances_called(task.subject, task, library)
        if len(called) != 1:
            yield f"{len(called)} things on the table are called {task.subject!r}"


def _marks(task: Task, *, paired: bool) -> Iterator[str]:
    letters = [mark.letter for mark in task.marks]
    if letters != (list(PAIR) if paired else []):
        yield f"its marks are {letters or 'none'}"
    camera = top_camera()
    for mark in task.marks:
        u, v = mark.point
        if not (0 <= u < camera.width_px and 0 <= v < camera.height_px):
            yield f"mark {mark.letter} lies outside of the picture"


def instances_called(name: str, task: Task, library: Library) -> Sequence[int]:
    """Instances on a task's table whose name in the catalogue is this one."""
    known = {spec.id: spec.name for spec in library.specs}
    return [o.instance for o in task.scene.objects if known.get(o.object_id) == name]
