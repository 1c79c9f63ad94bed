"""Frozen tasks say what they are about; with other words, hashed again, every one is caught."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest

from probe.assets.library import Library, open_library
from probe.cli.suite_verify import Unverified, verify
from probe.tasks.suite import Suite, selection
from probe.tasks.suite_file import digest_of, packaged_suite, read_suite, write_suite
from probe.tasks.task import Letter, Mark, Option, QuestionType, Task
from probe.tasks.type_rules import Form
from probe.verification.text import read_anew

V1, UNFILTERED, DEMO, SCANS = map(packaged_suite, ("v1", "v1-unfiltered", "demo", "v1-scans"))


@pytest.fixture(scope="module")
def library(cache) -> Library:
    return open_library("procedural", None, cache)


@pytest.mark.parametrize("suite", [V1, UNFILTERED, DEMO], ids=lambda suite: suite.name)
def test_frozen_tasks_say_what_they_are_about(library: Library, suite: Suite):
    assert {task.id: read_anew(task, library) for task in suite.tasks} == {
        task.id: () for task in suite.tasks
    }


def test_so_do_those_of_scans(assets: Path, cache: Path):
    scans = open_library("scans", assets, cache)
    assert [problem for task in SCANS.tasks for problem in read_anew(task, scans)] == []
    assert len(SCANS.tasks) == 60


def of(
    question_type: QuestionType, form: Form = "plain", fits: Callable[[Task], bool] = bool
) -> Task:
    """The first task of v1 of a type and form that fits."""
    return next(
        t for t in V1.tasks if t.question_type == question_type and t.form == form and fits(t)
    )


def says(task: Task, old: str, new: str) -> Task:
    """With other words in its question."""
    assert old in task.question
    return replace(task, question=task.question.replace(old, new))


def offers(task: Task, letter: Letter, text: str) -> Task:
    """With another text under a letter."""
    options = tuple(Option(o.letter, text) if o.letter == letter else o for o in task.options)
    return replace(task, options=options)


def text(task: Task, letter: Letter) -> str:
    return next(option.text for option in task.options if option.letter == letter)


def swapped(task: Task) -> Task:
    """With the texts of A and B in each other's places."""
    return offers(offers(task, "A", text(task, "B")), "B", text(task, "A"))


def proves(task: Task, *candidates: str, **measures: float) -> Task:
    """With another certificate."""
    proof = task.certificate
    changed = replace(
        proof,
        candidates=candidates or proof.candidates,
        measures={**proof.measures, **measures},
    )
    return replace(task, certificate=changed)


def places(a: Mark, b: Mark) -> str:
    return f"A at ({a.point[0]}, {a.point[1]}) and B at ({b.point[0]}, {b.point[1]})"


def relettered(task: Task) -> Task:
    """With A's mark on B's thing and the other way round, in the list and in the question."""
    a, b = task.marks
    marks = replace(b, letter="A"), replace(a, letter="B")
    return replace(says(task, places(a, b), places(*marks)), marks=marks)


BENEATH = of("beneath", fits=lambda task: task.answer == "B")
NONE = of("beneath", fits=lambda task: task.answer == "E")
FIND = of("find", fits=lambda task: task.answer == "C")
COUNT = of("count", fits=lambda task: task.answer != "E" and f" {task.subject}s " in task.question)
REDUCE = of("reduce", fits=lambda task: len(task.named) == 3)
COLOUR, DARKER, LIKE = (of("compare", form) for form in ("colour", "darker", "like"))
LARGER, LONGER = (of("size", form) for form in ("larger", "longer"))
OTHER_COLOUR = "teal" if COLOUR.subject != "teal" else "pink"
OTHER_COVER = "blue train"


def like_something_else(task: Task) -> Task:
    """Compare, with another thing on the table that it isn't like."""
    names = (o.object_id.removeprefix("proc_").replace("_", " ") for o in task.scene.objects)
    name = next(name for name in names if not name.startswith("pink"))
    return replace(says(task, task.subject, name), subject=name)


def two_named(task: Task) -> Task:
    """Reduce, with the last of three named things left out of the question."""
    first, second, third = task.subject.split(", ")
    return says(task, f"the {first}, the {second} and the {third}", f"the {first} and the {second}")


def the_true_one_offered(task: Task) -> Task:
    """With the true candidate offered although "none of the above" is said to be right."""
    there = next(o.object_id for o in task.scene.objects if o.instance == task.targets[0])
    return offers(task, "A", there.removeprefix("proc_").replace("_", " "))


FORGERIES: dict[str, Task] = {
    "other thing named": says(BENEATH, BENEATH.subject, OTHER_COVER),
    "other thing named, and subject": replace(
        says(BENEATH, BENEATH.subject, OTHER_COVER), subject=OTHER_COVER
    ),
    "wording of another type": replace(BENEATH, question=FIND.question),
    "wording of one's own": says(BENEATH, "?", ", roughly?") if "?" in BENEATH.question
    else says(BENEATH, ".", ", roughly."),
    "extra sentence": replace(BENEATH, question=f"{BENEATH.question} Hint: look at B."),
    "look-alike letter": says(BENEATH, "the", "th\u0435"),
    "invisible character": says(BENEATH, " the ", " \u200bthe "),
    "invisible character in an option": offers(FIND, "A", text(FIND, "A") + "\u200b"),
    "trailing space": replace(FIND, question=FIND.question + " "),
    "giraffe offered": offers(FIND, "A", "giraffe"),
    "giraffe is the answer": offers(FIND, "C", "giraffe"),
    "giraffe offered and planned": proves(
        offers(FIND, "A", "giraffe"), *FIND.certificate.candidates[:4], "proc_giraffe"
    ),
    "something on the table is offered and planned": proves(
        FIND,
        *FIND.certificate.candidates[:4],
        next(o.object_id for o in FIND.scene.objects if o.instance not in FIND.targets),
    ),
    "options in another order": swapped(BENEATH),
    "another letter": replace(FIND, answer="D"),
    "an option twice": offers(FIND, "A", text(FIND, "B")),
    "none of these": offers(FIND, "E", "None of these"),
    "the true one is offered beside none": the_true_one_offered(NONE),
    "none is right though the true one is offered": replace(BENEATH, answer="E"),
    "three options": replace(FIND, options=(*FIND.options[:2], *FIND.options[3:])),
    "subject in Find": replace(FIND, subject="lime"),
    "one counted thing too few in words": offers(COUNT, COUNT.answer, "0"),
    "number of letters": offers(COUNT, "A", "seven"),
    "numbers in another order": swapped(COUNT),
    "singular": says(COUNT, f"{COUNT.subject}s", COUNT.subject),
    "other noun": says(COUNT, f"{COUNT.subject}s", "limes"),
    "other noun, and subject": replace(says(COUNT, f"{COUNT.subject}s", "limes"), subject="lime"),
    "one counted thing left out": replace(COUNT, targets=COUNT.targets[1:]),
    "one named thing missing": two_named(REDUCE),
    "named twice": replace(REDUCE, named=(*REDUCE.named[:2], REDUCE.named[1])),
    "named in another order": replace(REDUCE, named=REDUCE.named[::-1]),
    "another colour": says(COLOUR, COLOUR.subject, OTHER_COLOUR),
    "another colour, and subject": replace(
        says(COLOUR, COLOUR.subject, OTHER_COLOUR), subject=OTHER_COLOUR
    ),
    "the other letter of two": replace(COLOUR, answer="A" if COLOUR.answer == "B" else "B"),
    "lighter for darker": says(DARKER, "dark", "light"),
    "like another thing": says(LIKE, LIKE.subject, "lime"),
    "like another thing, and subject": replace(says(LIKE, LIKE.subject, "lime"), subject="lime"),
    "like another thing on the table": like_something_else(LIKE),
    "form of another wording": replace(LIKE, form="darker"),
    "smaller for larger": replace(
        LARGER, question=of("size", "smaller").question.split(" In the first")[0]
        + " In the first" + LARGER.question.split(" In the first")[1],
    ),
    "smaller for larger, and form": replace(
        LARGER, form="smaller", question=of("size", "smaller").question.split(" In the first")[0]
        + " In the first" + LARGER.question.split(" In the first")[1],
    ),
    "marks swapped in words": says(LONGER, places(*LONGER.marks), places(*LONGER.marks[::-1])),
    "marks swapped": relettered(LONGER),
    "marks not told": replace(LONGER, question=LONGER.question.split(" In the first")[0]),
    "objects in another order": swapped(LONGER),
    "both marks on one thing": replace(
        LONGER, marks=(LONGER.marks[0], replace(LONGER.marks[1], instance=LONGER.targets[0]))
    ),
}  # fmt: skip


@pytest.mark.parametrize("forged", FORGERIES.values(), ids=FORGERIES)
def test_other_words_are_caught_though_their_hash_is_right(
    library: Library, tmp_path: Path, forged: Task
):
    path = tmp_path / "v1.json"
    write_suite(path, replace(V1, tasks=(forged,)))
    (task,) = read_suite(path).tasks
    assert digest_of(task) not in {digest_of(it) for it in V1.tasks}
    assert read_anew(task, library)


BROKEN: dict[str, Task] = {
    "2 targets, not 1": replace(FIND, targets=(1, 2)),
    "0 targets, not 1": replace(FIND, targets=()),
    "lists 1 candidates, not 5": proves(FIND, "proc_lime"),
    "doesn't state partly": replace(FIND, certificate=replace(FIND.certificate, measures={})),
    "which aren't there": replace(
        FIND, certificate=replace(FIND.certificate, visibility={99: FIND.certificate.visibility[1]})
    ),
    "isn't what beneath names": replace(BENEATH, cover=None),
    "isn't what reduce names": replace(REDUCE, named=()),
    "the catalogue has no 'proc_giraffe'": FORGERIES["giraffe offered and planned"],
    "its marks are none": replace(LONGER, marks=()),
    r"its marks are \['B', 'A'\]": replace(LONGER, marks=LONGER.marks[::-1]),
    "mark A lies outside": replace(
        LONGER, marks=(replace(LONGER.marks[0], point=(5000, 5)), LONGER.marks[1])
    ),
    "aren't of one shape": proves(COLOUR, *COLOUR.certificate.candidates[:3], "proc_lime"),
    "0 things on the table are called 'giraffe'": replace(LIKE, subject="giraffe"),
}


@pytest.mark.parametrize(("problem", "task"), BROKEN.items(), ids=BROKEN)
def test_what_a_task_lacks_is_told_before_anything_is_measured(
    library: Library, problem: str, task: Task
):
    with pytest.raises(AssertionError, match=problem):
        assert not read_anew(task, library)


def test_a_verdict_from_before_there_was_this_check_is_completed(tmp_path: Path):
    path, out = tmp_path / "some.json", tmp_path / "verdicts"
    # In square brackets: what a person reads mustn't be taken for mark-up.
    forged = offers(FIND, "A", "[/giraffe]")
    write_suite(path, selection(V1, (forged,), "some"))
    out.mkdir()
    (out / f"{forged.id}.json").write_text(
        f'{{"task": "{forged.id}", "kind": "find", "digest": "{digest_of(forged)}",'
        ' "problems": {"at rest": [], "hidden": [], "invariant": [], "unambiguous": [],'
        ' "solvable": []}, "solved": true}'
    )
    with pytest.raises(Unverified, match="1 tasks of suite some fail a check"):
        verify(str(path), out)
    assert "giraffe" in (out / f"{forged.id}.json").read_text()
