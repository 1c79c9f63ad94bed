"""Turns a scene that passed its checks into a Task: words, options, certificate. No checks."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from probe.generation.scene_view import SceneView
from probe.generation.task_plan import TaskPlan
from probe.scene.scene import Scene
from probe.scene.seeds import generator
from probe.tasks.options import drop_one
from probe.tasks.task import PAIR, Certificate, Mark, Option, QuestionType, Task
from probe.tasks.wordings import wordings


@dataclass(frozen=True)
class Draft:
    """All of a task but its words and letters.

    Attributes:
        question_type, scene, subject, targets, cover, named, marks, manipulations: As in Task.
        slots: What the wording's slots are filled with.
        candidates: Texts of the five candidates; none where the two marked things are the options.
        truth: Index of the true one, or of the marked thing that is.
        measures: As in Certificate.
        drawn_from: As Certificate.candidates.
    """

    question_type: QuestionType
    scene: Scene
    subject: str
    slots: Mapping[str, str]
    candidates: tuple[str, ...]
    truth: int
    targets: tuple[int, ...]
    measures: Mapping[str, float]
    drawn_from: tuple[str, ...]
    cover: int | None = None
    named: tuple[int, ...] = ()
    marks: tuple[Mark, ...] = ()
    manipulations: int | None = None


def write_task(draft: Draft, plan: TaskPlan, view: SceneView) -> Task:
    """The task of a draft, worded as planned."""
    scene = draft.scene
    rng = generator(scene.seed, "words", draft.question_type)
    wording = wordings(draft.question_type)[plan.wording]
    question = asked(wording.text, draft.slots, draft.marks)
    if draft.marks:
        options = tuple(Option(letter, f"Object {letter}") for letter in PAIR)
    else:
        options = drop_one(draft.candidates, draft.truth, plan.letter, rng)
    labels = view.labels(scene)
    visibility = view.visibility(scene, labels, [placed.instance for placed in scene.objects])
    return Task(
        id=task_id(draft.question_type, scene.seed),
        question_type=draft.question_type,
        form=wording.form,
        seed=scene.seed,
        subject=draft.subject,
        question=question,
        options=options,
        answer=plan.letter,
        scene=scene,
        targets=draft.targets,
        cover=draft.cover,
        named=draft.named,
        marks=draft.marks,
        certificate=Certificate(visibility, draft.measures, draft.drawn_from),
        camera=view.view,
        manipulations=draft.manipulations,
        version=plan.rules,
    )


def asked(wording: str, slots: Mapping[str, str], marks: Sequence[Mark]) -> str:
    """A question as agents read it: a wording with its slots filled, then where the marks are."""
    question = wording.format(**slots)
    return f"{question} {_places(marks)}" if marks else question


def _places(marks: Sequence[Mark]) -> str:
    """Where the marks are, for agents that see no picture or draw better than they read."""
    places = " and ".join(f"{mark.letter} at ({mark.point[0]}, {mark.point[1]})" for mark in marks)
    return f"In the first picture, the marks are {places}."


def task_id(question_type: QuestionType, seed: int) -> str:
    """A name that differs from task to task and tells neither the seed nor the answer."""
    return f"{question_type}-{hashlib.sha256(f'{question_type} {seed}'.encode()).hexdigest()[:8]}"
