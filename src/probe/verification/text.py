"""Does a task ask, word for word, what it is about? From the catalogue alone; no pictures."""

from __future__ import annotations

import difflib
from collections.abc import Callable, Iterator, Mapping

from probe.assets.library import Library
from probe.assets.spec import ObjectSpec
from probe.generation.alike import told_apart
from probe.generation.task_writer import asked
from probe.tasks.english import listed, plural
from probe.tasks.task import PAIR, QuestionType, Task
from probe.tasks.wordings import wordings
from probe.verification.completeness import instances_called, makeup_problems
from probe.verification.options import option_problems


def read_anew(task: Task, library: Library) -> tuple[str, ...]:
    """All that is wrong with a task's text, or with what it should be about."""
    return tuple(makeup_problems(task, library)) or tuple(text_problems(task, library))


def text_problems(task: Task, library: Library) -> Iterator[str]:
    """What a person reads that isn't what the type's wordings and the catalogue give.

    Args:
        task: One of which nothing is missing; see makeup_problems().
        library: Has its objects and its candidates.
    """
    yield from _SUBJECTS[task.question_type](task, library)
    yield from _question(task, library)
    yield from option_problems(task, library)


def _question(task: Task, library: Library) -> Iterator[str]:
    slots = _slots(task, library)
    ways = [w.text for w in wordings(task.question_type) if w.form == task.form]
    texts = [asked(way, slots, task.marks) for way in ways]
    if not texts:
        yield f"{task.question_type} has no form {task.form!r}"
    elif task.question not in texts:
        (nearest,) = difflib.get_close_matches(task.question, texts, n=1, cutoff=0.0)
        # ascii() shows what can't be seen, or looks like something else.
        yield f"it asks {ascii(task.question)}; the nearest that it may ask is {ascii(nearest)}"


def _slots(task: Task, library: Library) -> Mapping[str, str]:
    """What fills a wording's slots, from the table where it can be."""
    if task.question_type == "beneath" and task.cover is not None:
        return {"cover": _spec(task, task.cover, library).name}
    if task.question_type == "count":
        return {"names": str(plural(task.subject))}
    if task.question_type == "reduce":
        return {"names": listed(_named(task, library))}
    return {"colour": task.subject, "name": task.subject}


def _beneath(task: Task, library: Library) -> Iterator[str]:
    assert task.cover is not None
    if task.cover in task.targets:
        yield "what covers and what is covered are the same"
    yield from _is_called(task, _spec(task, task.cover, library).name)


def _count(task: Task, library: Library) -> Iterator[str]:
    if plural(task.subject) is None:
        yield f"{task.subject!r} has no plural"
    measures = task.certificate.measures
    if measures["clear"] + measures["hidden"] != len(task.targets):
        yield f"it counts {len(task.targets)} and states other numbers of clear and hidden ones"
    if sorted(task.targets) != sorted(instances_called(task.subject, task, library)):
        yield f"it doesn't count all that is called {task.subject!r}"
    if task.targets:
        return
    # None is there: then nothing there may be taken for one.
    shown = {library[placed.object_id] for placed in task.scene.objects}
    if not any(told_apart([*shown, spec]) for spec in _called(task.subject, library)):
        yield f"{task.subject!r} isn't in the catalogue, or is like something on the table"


def _reduce(task: Task, library: Library) -> Iterator[str]:
    if len(set(task.named)) < len(task.named) or set(task.named) & set(task.targets):
        yield "it names a thing twice, or the hidden one"
    yield from _is_called(task, ", ".join(_named(task, library)))


def _compare(task: Task, library: Library) -> Iterator[str]:
    yield from _pair(task)
    if task.form == "darker":
        yield from _is_called(task, "")
        return
    right, wrong = _right_first(task, library)
    wanted = task.subject
    if task.form == "like":
        (third,) = instances_called(task.subject, task, library)
        wanted = _spec(task, third, library).colours[0]
        if third in task.targets:
            yield "it compares a marked thing with itself"
    if right.colours[0] != wanted or wrong.colours[0] == wanted:
        yield f"of the two marked things, {task.answer} alone should be mainly {wanted}"


def _size(task: Task, library: Library) -> Iterator[str]:
    yield from _pair(task)
    yield from _is_called(task, "")
    right, wrong = (max(spec.size) for spec in _right_first(task, library))
    if (right > wrong) == (task.form == "smaller"):
        yield f"by the catalogue's sizes, {task.answer} isn't the {task.form} one"


def _pair(task: Task) -> Iterator[str]:
    a, b = (mark.instance for mark in task.marks)
    if a == b or task.targets != (a, b):
        yield "its marks aren't on its two targets, A first"
    lie_there = tuple(task.scene[number].object_id for number in (a, b))
    if task.certificate.candidates[: len(PAIR)] != lie_there:
        yield "its certificate is about other things than the marked ones"


def _is_called(task: Task, subject: str) -> Iterator[str]:
    if task.subject != subject:
        yield f"its subject is {ascii(task.subject)}, not {ascii(subject)}"


def _spec(task: Task, instance: int, library: Library) -> ObjectSpec:
    return library[task.scene[instance].object_id]


def _called(name: str, library: Library) -> list[ObjectSpec]:
    return [spec for spec in library.specs if spec.name == name]


def _named(task: Task, library: Library) -> list[str]:
    return [_spec(task, number, library).name for number in task.named]


def _right_first(task: Task, library: Library) -> list[ObjectSpec]:
    marks = sorted(task.marks, key=lambda mark: mark.letter != task.answer)
    return [_spec(task, mark.instance, library) for mark in marks]


def _find(task: Task, library: Library) -> Iterator[str]:
    del library  # which of them lies there is said by the options alone
    yield from _is_called(task, "")


_SUBJECTS: dict[QuestionType, Callable[[Task, Library], Iterator[str]]] = {
    "beneath": _beneath,
    "compare": _compare,
    "count": _count,
    "find": _find,
    "reduce": _reduce,
    "size": _size,
}
"""Is what a type asks about what is said to be there, and does the catalogue give the answer?"""
