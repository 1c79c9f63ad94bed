"""Is the answer true, and the only one? From the starting scene and the library alone."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

from probe.assets.colour.difference import ciede2000
from probe.generation.alike import told_apart
from probe.generation.palettes import main_colour
from probe.generation.sizes import extent_of
from probe.tasks.task import NONE_OF_THE_ABOVE, PAIR, Task
from probe.tasks.truth import (
    DIFFERENT,
    how_many,
    which_beneath,
    which_darker,
    which_like,
    which_on_table,
    which_size,
)
from probe.verification.remeasure import Remeasurement


def truth_problems(task: Task, anew: Remeasurement) -> Iterator[str]:
    """What is wrong with the letter that is said to be right."""
    texts = {option.letter: option.text for option in task.options}
    try:
        true = _true_text(task, anew)
    except ValueError as error:
        yield str(error)
        return
    if true in texts.values():
        if texts[task.answer] != true:
            yield f"{true} is right, not {task.answer}"
    elif texts[task.answer] != NONE_OF_THE_ABOVE:
        yield f"{true} is right and isn't offered, but the answer is {task.answer}"


def _true_text(task: Task, anew: Remeasurement) -> str:
    """The option that is true, by the truth functions of the starting scene alone."""
    scene, library, drawn = task.scene, anew.library, task.certificate.candidates
    if task.question_type == "count":
        named = [o.object_id for o in scene.objects if library[o.object_id].name == task.subject]
        return str(how_many(scene, named[0]) if named else 0)
    if task.question_type == "beneath":
        assert task.cover is not None
        known = [o.instance for o in scene.objects if o.object_id in drawn]
        shapes = anew.view.silhouettes(scene, [*known, task.cover])
        return library[which_beneath(scene, drawn, task.cover, shapes).object_id].name
    if task.question_type in ("find", "reduce"):
        return library[which_on_table(scene, drawn).object_id].name
    return f"Object {_pair(task, anew)}"


def _pair(task: Task, anew: Remeasurement) -> str:
    ids = [task.scene[mark.instance].object_id for mark in task.marks]
    if task.question_type == "size":
        return which_size(task.form, *(extent_of(anew.library, id) for id in ids))
    a, b = (main_colour(anew.library, id) for id in ids)
    if task.form == "darker":
        return which_darker(a, b)
    if task.form == "like":
        reference = anew.called(task.subject).object_id
        return which_like(a, b, main_colour(anew.library, reference))
    return PAIR[[anew.library[id].colours[0] for id in ids].index(task.subject)]


def clarity_problems(task: Task, anew: Remeasurement) -> Iterator[str]:
    """What could be understood in more than one way."""
    texts = [option.text for option in task.options]
    if len(set(texts)) < len(texts):
        yield "two options are the same"
    once = {o.object_id: o for o in task.scene.objects}
    specs = [anew.library[object_id] for object_id in once]
    if not told_apart(specs):
        yield "two kinds of things share a name, or category and main colour"
    copies = Counter(o.object_id for o in task.scene.objects)
    several = {anew.library[id].name for id, count in copies.items() if count > 1}
    if several - ({task.subject} if task.question_type == "count" else set()):
        yield f"there are several of {', '.join(sorted(several))}"
    if task.question_type in ("beneath", "find", "reduce"):
        present = {spec.name for spec in specs} & set(texts)
        if len(present) > 1:
            yield f"several options are on the table: {', '.join(sorted(present))}"
    if task.question_type == "compare":
        a, b = (
            main_colour(anew.library, task.scene[mark.instance].object_id) for mark in task.marks
        )
        if float(ciede2000(a, b)) < DIFFERENT:
            yield "the two marked things are alike in colour"
