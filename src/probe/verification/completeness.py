"""Has a task all that its type is made of? Other checks rely on it. No text, no pictures."""

from __future__ import annotations

from collections.abc import Iterator

from probe.assets.library import Library
from probe.errors import UnknownName
from probe.generation.necessary import NECESSARY
from probe.tasks.task import PAIR, STEP_RULES, Task
from probe.tasks.type_rules import rules_of
from probe.verification.type_verifier import verifier_of


def makeup_problems(task: Task, library: Library) -> Iterator[str]:
    """What a task lacks, or has too much of; other checks rely on what this lets pass."""
    verifier, proof = verifier_of(task.question_type), task.certificate
    makeup = verifier.makeup
    if makeup.targets not in (None, len(task.targets)):
        yield f"it has {len(task.targets)} targets, not {makeup.targets}"
    if len(proof.candidates) != makeup.candidates:
        yield f"its certificate lists {len(proof.candidates)} candidates, not {makeup.candidates}"
    measures = {*makeup.measures, *([NECESSARY] if task.version >= STEP_RULES else [])}
    if missing := sorted(measures - set(proof.measures)):
        yield f"its certificate doesn't state {', '.join(missing)}"
    if strange := set(proof.visibility) - {placed.instance for placed in task.scene.objects}:
        yield f"its certificate measures objects {sorted(strange)}, which aren't there"
    if (task.cover is not None) != makeup.cover or bool(task.named) != makeup.named:
        yield f"what it names isn't what {task.question_type} names"
    if task.manipulations != makeup.manipulations:
        yield f"it allows {task.manipulations} manipulations, not {makeup.manipulations}"
    yield from _marks(task, paired=rules_of(task.question_type).paired)
    unknown = list(_unknown(task, library))
    yield from unknown
    if not unknown:
        yield from verifier.listed(task, library)


def _unknown(task: Task, library: Library) -> Iterator[str]:
    listed = () if rules_of(task.question_type).numbered else task.certificate.candidates
    for object_id in (*(placed.object_id for placed in task.scene.objects), *listed):
        try:
            library[object_id]
        except UnknownName:
            yield f"the catalogue has no {object_id!r}"


def _marks(task: Task, *, paired: bool) -> Iterator[str]:
    letters = [mark.letter for mark in task.marks]
    if letters != (list(PAIR) if paired else []):
        yield f"its marks are {letters or 'none'}"
    camera = task.viewpoint.camera
    for mark in task.marks:
        u, v = mark.point
        if not (0 <= u < camera.width_px and 0 <= v < camera.height_px):
            yield f"mark {mark.letter} lies outside of the picture"
