"""Are a task's options those that were planned, and the truth under its letter? No pictures."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from probe.assets.library import Library
from probe.generation.likeness import (
    LOOSE_TOLERANCE,
    SIDES_TOLERANCE,
    TWIN_TOLERANCE,
    are_level,
    level_of,
    longest,
    sides_alike,
    told_apart,
)
from probe.tasks.options import MOST_HIDDEN, most_counted
from probe.tasks.task import DEPTH_RULES, LETTERS, NONE_OF_THE_ABOVE, PAIR, SIX_RULES, Task
from probe.tasks.type_rules import rules_of

_ROUNDING = 1e-9


def option_problems(task: Task, library: Library) -> Iterator[str]:
    """What is offered that wasn't planned, and whether the answer's letter bears the truth.

    Args:
        task: One of which nothing is missing; see makeup_problems().
        library: Has its objects and its candidates.
    """
    texts = [option.text for option in task.options]
    if task.marks:
        if texts != [f"Object {letter}" for letter in PAIR]:
            yield f"it offers {_shown(texts)}"
        return
    if rules_of(task.question_type).numbered:
        yield from _numbers(task)
        drawn, truth = task.certificate.candidates, str(len(task.targets))
    else:
        yield from _candidates(task, library)
        drawn = [library[object_id].name for object_id in task.certificate.candidates]
        truth = library[task.scene[task.targets[0]].object_id].name
    yield from _offered(task, texts, drawn, truth)


def _offered(task: Task, texts: Sequence[str], drawn: Sequence[str], truth: str) -> Iterator[str]:
    """Four of five candidates and "none of the above", the truth where the letter says."""
    *offered, last = texts
    if len(texts) != len(LETTERS) or last != NONE_OF_THE_ABOVE:
        yield f"it offers {_shown(texts)}, and not four things and {NONE_OF_THE_ABOVE!r}"
        return
    if strange := [text for text in offered if text not in drawn]:
        yield f"it offers {_shown(strange)}, not among its candidates"
    if len(set(offered)) < len(offered):
        yield "it offers something twice"
    right = LETTERS[offered.index(truth)] if truth in offered else LETTERS[-1]
    if task.answer != right:
        yield f"{ascii(truth)} is true, so that {right} is right, not {task.answer}"


def _numbers(task: Task) -> Iterator[str]:
    drawn, most = task.certificate.candidates, most_counted(task.version)
    every = [str(number) for number in range(most + 1)]
    if list(drawn) != [number for number in every if number in drawn]:
        yield f"its candidates are {_shown(drawn)}: not numbers to {most}, in order"
    clear = int(task.certificate.measures["clear"])
    near = [str(clear + hidden) for hidden in range(MOST_HIDDEN + 1)]
    if not {*near} <= {*drawn}:
        yield f"{clear} are clear, but {near[0]} to {near[-1]} aren't all among its candidates"
    elif task.version >= SIX_RULES and near not in (list(drawn[:3]), list(drawn[-3:])):
        yield f"of its candidates, some are below {near[0]} and some above {near[-1]}"


def _candidates(task: Task, library: Library) -> Iterator[str]:
    """Only the hidden candidate is on the table, unless others may be; all could be it."""
    rules, drawn = rules_of(task.question_type), task.certificate.candidates
    specs = [library[object_id] for object_id in drawn]
    there = [o.instance for o in task.scene.objects if o.object_id in drawn]
    if rules.rivals and (task.targets[0] not in there or not {*there} <= {*task.targets}):
        yield f"of its candidates, objects {there} are on the table; its targets are {task.targets}"
    many = 1 + rules.bystanders
    if rules.bystanders and (task.targets[0] not in there or len(there) != many):
        yield f"of its candidates, objects {there} are on the table, not {many} with its answer"
    if not (rules.rivals or rules.bystanders) and there != list(task.targets):
        yield f"of its candidates, objects {there} are on the table, not {list(task.targets)} alone"
    if not told_apart(specs):
        yield "two candidates share a name, or category and main colour"
    loose = task.certificate.measures.get("partly", 0.0) > 0
    tolerance = LOOSE_TOLERANCE if loose else TWIN_TOLERANCE
    sizes = [longest(spec) for spec in specs]
    if not rules.rivals and max(sizes) > min(sizes) * (1 + tolerance) + _ROUNDING:
        yield f"its candidates' longest sides differ by more than {tolerance:.0%}"


def sides_problems(task: Task, library: Library) -> Iterator[str]:
    """That candidates are alike in length, width and height: a cover may rest on them."""
    specs = [library[object_id] for object_id in task.certificate.candidates]
    if not sides_alike(specs, SIDES_TOLERANCE + _ROUNDING):
        yield f"a side of its candidates differs by more than {SIDES_TOLERANCE:.0%}"


def depth_problems(task: Task, library: Library) -> Iterator[str]:
    """The same, where the rules that the task was made by ask for it and its target is hidden."""
    partly = task.certificate.measures.get("partly", 0.0) > 0
    if task.version >= DEPTH_RULES and not partly:
        yield from sides_problems(task, library)


def level_problems(task: Task, library: Library) -> Iterator[str]:
    """That candidates are equally high, by rules that ask for it: a slab may rest on them."""
    level = level_of(task.version)
    specs = [library[object_id] for object_id in task.certificate.candidates]
    if level is not None and not are_level(specs, level + _ROUNDING):
        yield f"its candidates' heights differ by more than {1000 * level:g} mm"


def _shown(texts: Sequence[str]) -> str:
    # ascii() shows what can't be seen, or looks like something else.
    return ", ".join(ascii(text) for text in texts)
