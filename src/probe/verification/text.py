"""Does a task ask, word for word, what it is about? From the catalogue alone; no pictures."""

from __future__ import annotations

import difflib
from collections.abc import Iterator

from probe.assets.library import Library
from probe.generation.task_writer import asked
from probe.tasks.task import Task
from probe.tasks.wordings import wordings
from probe.verification.completeness import makeup_problems
from probe.verification.options import option_problems
from probe.verification.type_verifier import verifier_of


def read_anew(task: Task, library: Library) -> tuple[str, ...]:
    """All that is wrong with a task's text, or with what it should be about."""
    return tuple(makeup_problems(task, library)) or tuple(text_problems(task, library))


def text_problems(task: Task, library: Library) -> Iterator[str]:
    """What a person reads that isn't what the type's wordings and the catalogue give.

    Args:
        task: One of which nothing is missing; see makeup_problems().
        library: Has its objects and its candidates.
    """
    yield from verifier_of(task.question_type).subject(task, library)
    yield from _question(task, library)
    yield from option_problems(task, library)


def _question(task: Task, library: Library) -> Iterator[str]:
    slots = verifier_of(task.question_type).slots(task, library)
    ways = [w.text for w in wordings(task.question_type) if w.form == task.form]
    texts = [asked(way, slots, task.marks) for way in ways]
    if not texts:
        yield f"{task.question_type} has no form {task.form!r}"
    elif task.question not in texts:
        (nearest,) = difflib.get_close_matches(task.question, texts, n=1, cutoff=0.0)
        # ascii() shows what can't be seen, or looks like something else.
        yield f"it asks {ascii(task.question)}; the nearest that it may ask is {ascii(nearest)}"
