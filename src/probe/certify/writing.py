"""Turns a scene that passed its checks into a Task: words, options, certificate. No checks."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from dataclasses import dataclass

from probe.certify.plan import Plan
from probe.certify.view import View
from probe.scene.scene import Scene
from probe.scene.seeds import generator
from probe.tasks.options import drop_one
from probe.tasks.task import Certificate, QuestionKind, Task
from probe.tasks.wordings import wordings


@dataclass(frozen=True)
class Draft:
    """All of a task but its words and letters.

    Attributes:
        kind, scene, subject, targets, cover: As in Task.
        slots: What the wording's slots are filled with.
        candidates: Texts of the five candidates.
        truth: Index of the true one.
        measures: As in Certificate.
        drawn_from: As Certificate.candidates.
    """

    kind: QuestionKind
    scene: Scene
    subject: str
    slots: Mapping[str, str]
    candidates: tuple[str, ...]
    truth: int
    targets: tuple[int, ...]
    cover: int | None
    measures: Mapping[str, float]
    drawn_from: tuple[str, ...]


def write_task(draft: Draft, plan: Plan, view: View) -> Task:
    """The task of a draft; its wording is drawn by the scene's seed."""
    scene = draft.scene
    rng = generator(scene.seed, "words", draft.kind)
    texts = wordings(draft.kind)
    wording = texts[int(rng.integers(len(texts)))]
    labels = view.labels(scene)
    visibility = view.visibility(scene, labels, [placed.instance for placed in scene.objects])
    return Task(
        id=task_id(draft.kind, scene.seed),
        kind=draft.kind,
        seed=scene.seed,
        subject=draft.subject,
        question=wording.format(**draft.slots),
        options=drop_one(draft.candidates, draft.truth, plan.letter, rng),
        answer=plan.letter,
        scene=scene,
        targets=draft.targets,
        cover=draft.cover,
        certificate=Certificate(visibility, draft.measures, draft.drawn_from),
    )


def task_id(kind: QuestionKind, seed: int) -> str:
    """A name that differs from task to task and tells neither the seed nor the answer."""
    return f"{kind}-{hashlib.sha256(f'{kind} {seed}'.encode()).hexdigest()[:8]}"
