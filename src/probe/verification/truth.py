"""Is the answer true, and the only one? From the starting scene and the library alone."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Sequence
from itertools import combinations

from probe.generation.likeness import says_in_part, told_apart, whole_names_by
from probe.tasks.task import NONE_OF_THE_ABOVE, Task
from probe.tasks.truth import which_on_table
from probe.tasks.type_rules import rules_of
from probe.verification.remeasure import Remeasurement
from probe.verification.type_verifier import verifier_of


def truth_problems(task: Task, anew: Remeasurement) -> Iterator[str]:
    """What is wrong with the letter that is said to be right."""
    texts = {option.letter: option.text for option in task.options}
    try:
        true = verifier_of(task.question_type).true_text(task, anew)
    except ValueError as error:
        yield str(error)
        return
    if true in texts.values():
        if texts[task.answer] != true:
            yield f"{true} is right, not {task.answer}"
    elif texts[task.answer] != NONE_OF_THE_ABOVE:
        yield f"{true} is right and isn't offered, but the answer is {task.answer}"


def clarity_problems(task: Task, anew: Remeasurement) -> Iterator[str]:
    """What could be understood in more than one way."""
    texts, rules = [option.text for option in task.options], rules_of(task.question_type)
    if len(set(texts)) < len(texts):
        yield "two options are the same"
    if whole_names_by(task.version) and rules.answers == "objects":
        # Also those that aren't offered: one of them may be what "none of the above" stands for.
        drawn = [anew.library[object_id].name for object_id in task.certificate.candidates]
        yield from _said_in_part(drawn)
    once = {o.object_id: o for o in task.scene.objects}
    specs = [anew.library[object_id] for object_id in once]
    if not told_apart(specs):
        yield "two kinds of things share a name, or category and main colour"
    copies = Counter(o.object_id for o in task.scene.objects)
    several = {anew.library[id].name for id, count in copies.items() if count > 1}
    if several - ({task.subject} if rules.numbered or rules.copies else set()):
        yield f"there are several of {', '.join(sorted(several))}"
    if rules.answers == "objects" and not (rules.rivals or rules.bystanders):
        present = {spec.name for spec in specs} & set(texts)
        if len(present) > 1:
            yield f"several options are on the table: {', '.join(sorted(present))}"
    yield from verifier_of(task.question_type).clear(task, anew)


def _said_in_part(names: Sequence[str]) -> Iterator[str]:
    for one, other in combinations(names, 2):
        if says_in_part(one, other):
            yield f"{one} and {other} may both be said of one thing"


def candidate_on_table(task: Task, anew: Remeasurement) -> str:
    """Name of the one candidate that is on the table.

    Raises:
        ValueError: Not exactly one is.
    """
    found = which_on_table(task.scene, task.certificate.candidates)
    return anew.library[found.object_id].name
