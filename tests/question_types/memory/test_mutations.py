"""A frozen task of Memory in which one thing is changed: each change is found."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest

from probe.assets.library import Library
from probe.render.renderer import Renderer
from probe.tasks.english import listed
from probe.tasks.suite_file import read_suite
from probe.tasks.task import Task
from probe.verification.check import CheckDepth, check
from probe.verification.text import read_anew

(TASK,) = read_suite(Path(__file__).parent / "tasks.json").tasks
Mutation = Callable[[Task], Task]


def about_another(task: Task, library: Library, number: int) -> Task:
    """Asks about another of the three covers, in its words as well; the list of all stays."""
    names = {it: library[task.scene[it].object_id].name for it in task.named}
    cover = [it for it in task.named if it != task.cover][number]
    asked, other = task.subject.split(", ")[0], names[cover]
    listing = listed(list(names.values()))
    assert task.question.count(listing) == 1
    question = task.question.replace(listing, "<all>").replace(asked, other)
    subject = ", ".join([other, *(name for name in names.values() if name != other)])
    question = question.replace("<all>", listing)
    return replace(task, question=question, cover=cover, subject=subject)


def bystanders(task: Task) -> list[int]:
    """Candidates on the table that aren't the answer."""
    drawn = task.certificate.candidates
    return [
        it.instance
        for it in task.scene.objects
        if it.object_id in drawn and it.instance not in task.targets
    ]


def another_answer(task: Task) -> Task:
    """A bystander is the target, and its letter is right."""
    return replace(task, targets=(bystanders(task)[0],))


def listed_otherwise(task: Task) -> Task:
    return replace(task, named=task.named[::-1])


def one_less(task: Task) -> Task:
    return replace(task, named=tuple(it for it in task.named if it != task.cover))


def hidden_one_named(task: Task) -> Task:
    return replace(task, named=(*task.named[:-1], task.targets[0]))


def others_first(task: Task) -> Task:
    return replace(task, subject=", ".join(reversed(task.subject.split(", "))))


def may_move(task: Task) -> Task:
    return replace(task, question=task.question.replace("5 centimetres", "50 centimetres"))


def no_cover(task: Task) -> Task:
    return replace(task, cover=None)


def a_stranger_beside(task: Task) -> Task:
    """In a bystander's place is something that isn't among the candidates."""
    beside, known = bystanders(task)[0], {*task.targets, *task.named, *bystanders(task)}
    stranger = next(it.object_id for it in task.scene.objects if it.instance not in known)
    objects = tuple(
        replace(it, object_id=stranger) if it.instance == beside else it
        for it in task.scene.objects
    )
    return replace(task, scene=replace(task.scene, objects=objects))


@pytest.mark.parametrize(
    ("mutation", "told"),
    [
        (another_answer, "is true"),
        (listed_otherwise, "it asks"),
        (one_less, "name 3 things"),
        (hidden_one_named, "it names the hidden one"),
        (others_first, "its subject is"),
        (may_move, "it asks"),
        (no_cover, "what it names"),
        (a_stranger_beside, "not 3 with its answer"),
    ],
)
def test_what_the_text_tells_otherwise_is_found(library: Library, mutation: Mutation, told: str):
    assert read_anew(TASK, library) == ()
    assert any(told in it for it in read_anew(mutation(TASK), library))


@pytest.mark.slow
@pytest.mark.parametrize("number", [0, 1])
def test_a_question_about_another_cover_has_another_answer(
    library: Library, renderer: Renderer, number: int
):
    wrong = about_another(TASK, library, number)
    assert read_anew(wrong, library) == ()
    found = check(wrong, library, renderer, CheckDepth(solve=False)).problems
    told = "; ".join(problem for some in found.values() for problem in some)
    assert "is right" in told and f"under cover {wrong.cover}" in told
