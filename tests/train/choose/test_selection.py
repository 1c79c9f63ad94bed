from __future__ import annotations

from collections import Counter
from dataclasses import replace
from itertools import pairwise

import pytest

from lessons import lesson, reminded, training_task
from probe.errors import BadData
from probe.tasks.task import LETTERS
from probe.train.choose.candidates import EpisodeCandidate
from probe.train.choose.evaluation import evaluation_of
from probe.train.choose.selection import Recipe, select
from run_folders import DEMO

NOTHING = evaluation_of([])


def chosen(lessons, **recipe):
    return select(lessons, NOTHING, Recipe(**recipe))


def ids(selection):
    return [(it.task.id, it.record.setting) for it in selection.chosen]


def test_only_what_was_right_is_learnt():
    good, bad = lesson(training_task(1)), lesson(training_task(2), right=False)
    missing = EpisodeCandidate(training_task(3), replace(good.record, end="fault"), None)
    found = chosen([good, bad, missing])
    assert ids(found) == [(good.task.id, "agentic")]
    assert found.dropped == {"wrong or unanswered": 1, "missing": 1}


def test_what_ended_at_the_first_look_can_be_left_out():
    looked = lesson(training_task(1), statuses=())
    lifted = lesson(training_task(2), statuses=(("mug", "done"),))
    direct, wrong = (
        lesson(training_task(3), setting="direct"),
        lesson(training_task(4), right=False),
    )
    found = chosen([looked, lifted, direct, wrong], least=1, direct_share=1.0)
    assert ids(found) == [(lifted.task.id, "agentic"), (direct.task.id, "direct")]
    assert found.dropped == {"fewer manipulations than --least": 1, "wrong or unanswered": 1}
    assert len(chosen([looked, lifted]).chosen) == 2


def test_where_no_tools_were_needed_the_answer_at_once_is_learnt():
    task = training_task(1)
    found = chosen([lesson(task), lesson(task, setting="direct")], direct_share=1.0)
    assert ids(found) == [(task.id, "direct")]


def test_a_lucky_answer_is_not_learnt():
    task = training_task(1)
    tries = [lesson(task, setting="direct"), lesson(task, setting="direct", right=False, run=1)]
    found = chosen([*tries, lesson(task)], direct_share=1.0)
    assert ids(found) == [(task.id, "agentic")]
    assert found.dropped["right without tools, but not each time"] == 1


def test_no_more_than_the_share_is_without_tools():
    direct = [lesson(training_task(n), setting="direct") for n in range(10)]
    agentic = [lesson(training_task(n)) for n in range(10, 16)]
    settings = Counter(
        setting for _, setting in ids(chosen([*direct, *agentic], direct_share=0.25))
    )
    assert settings == {"direct": 2, "agentic": 6}


def test_beyond_the_share_a_task_is_shown_with_tools_if_it_was_solved_so():
    tasks = [training_task(n) for n in range(4)]
    both = [lesson(task, setting=setting) for task in tasks for setting in ("direct", "agentic")]
    assert Counter(setting for _, setting in ids(chosen(both, direct_share=0.0))) == {"agentic": 4}


def test_the_shortest_of_several_is_taken():
    task = training_task(1)
    long = lesson(task, statuses=[("mug", "done"), ("box", "done")])
    short = lesson(task, run=1)
    assert [it.record.run for it in chosen([long, short]).chosen] == [1]


def test_wasteful_episodes_are_left_out():
    others = [lesson(training_task(n)) for n in range(5)]
    wasteful = lesson(training_task(9), statuses=[(f"thing {n}", "done") for n in range(4)])
    found = chosen([*others, wasteful])
    assert len(found.chosen) == 5 and found.limits == {"find": 2}
    assert found.dropped == {"too many manipulations": 1}


def test_letters_are_taken_in_turn():
    many = [lesson(training_task(n, answer="C")) for n in range(8)]
    few = [lesson(training_task(n, answer="A")) for n in range(8, 10)]
    letters = Counter(it.task.answer for it in chosen([*many, *few], counts={"find": 4}).chosen)
    assert letters == {"A": 2, "C": 2}


def test_the_same_task_in_two_collections_counts_once():
    assert len(chosen([lesson(training_task(1)), lesson(training_task(1))]).chosen) == 1


def test_counts_hold_for_each_type_and_an_empty_one_is_told():
    lessons = [
        lesson(training_task(n, question_type))
        for n in range(3)
        for question_type in ("find", "count")
    ]
    found = chosen(lessons, counts={"find": 1, "count": 2, "beneath": 0})
    assert Counter(it.task.question_type for it in found.chosen) == {"find": 1, "count": 2}
    words = r"size: 5 examples are wanted, .*--counts size 0"
    with pytest.raises(BadData, match=words):
        chosen(lessons, counts={"size": 5})


@pytest.mark.parametrize(
    ("counts", "expected"),
    [
        ({}, {"find": 4, "count": 2}),
        ({"find": 9, "count": 9, "size": 0}, {"find": 4, "count": 2}),
        ({"find": 4}, {"find": 3, "count": 3}),
        ({"find": 2}, {"find": 2, "count": 4}),
        ({"count": 0}, {"find": 6}),
    ],
)
def test_a_total_is_shared_in_proportion(counts, expected):
    lessons = [
        *(lesson(training_task(n, "find")) for n in range(8)),
        *(lesson(training_task(n, "count")) for n in range(4)),
    ]
    found = chosen(lessons, counts=counts, total=6)
    assert Counter(it.task.question_type for it in found.chosen) == expected


@pytest.mark.parametrize("counts", [{}, {"find": 1, "count": 9}])
def test_a_total_that_cannot_be_had_is_told(counts):
    lessons = [lesson(training_task(n, kind)) for n in range(4) for kind in ("find", "count")]
    with pytest.raises(BadData, match=r"--total: wants 9 examples, and [58] can be had"):
        chosen(lessons, counts=counts, total=9)


def test_fewer_examples_are_among_more():
    """With these counts, largest remainders would take from a type in 13 of the steps."""
    counts = {"beneath": 5, "count": 43, "find": 43}
    lessons = [
        lesson(training_task(n, kind, answer=LETTERS[n % 3]))
        for kind, count in counts.items()
        for n in range(count)
    ]
    sets = [set(ids(chosen(lessons, total=total, seed=3))) for total in range(1, 92)]
    assert [len(it) for it in sets] == [*range(1, 92)]
    assert all(few < more for few, more in pairwise(sets))


def test_what_was_solved_without_tools_alone_is_no_part_of_a_total():
    direct = [lesson(training_task(n, "count"), setting="direct") for n in range(6)]
    agentic = [lesson(training_task(n, "find")) for n in range(4)]
    found = chosen([*direct, *agentic], total=4, direct_share=0.0)
    assert Counter(it.task.question_type for it in found.chosen) == {"find": 4}
    with pytest.raises(BadData, match="wants 5 examples, and 4 can be had"):
        chosen([*direct, *agentic], total=5, direct_share=0.0)


def test_evaluation_is_refused_and_reported():
    leaked = replace(training_task(1), seed=5)
    selection = chosen([lesson(leaked), lesson(leaked, setting="direct"), lesson(training_task(2))])
    assert [it.task for it in selection.refused] == [leaked.id]
    assert selection.dropped == {"of evaluation": 2}
    assert len(selection.chosen) == 1


@pytest.mark.parametrize("right", [True, False])
@pytest.mark.parametrize("last", [True, False])
def test_a_verdict_holds_for_a_task_and_not_for_its_id(right, last):
    """Collections with other objects give other scenes the same ids."""
    clean = training_task(1)
    leaked = replace(clean, scene=DEMO.tasks[0].scene)
    lessons = [lesson(leaked), lesson(clean, right=right)]
    found = select(lessons if last else lessons[::-1], evaluation_of([DEMO]), Recipe())
    assert [it.task for it in found.chosen] == [clean] * right
    assert [(it.task, it.leak) for it in found.refused] == [(leaked.id, "scene")]


def test_a_type_that_was_solved_without_tools_alone_is_told():
    direct = [lesson(training_task(n), setting="direct") for n in range(4)]
    counted = [lesson(training_task(n, "count")) for n in range(4)]
    words = r"find: 2 examples are wanted, .*without tools alone.*--direct-share 1, .*counts.find 0"
    with pytest.raises(BadData, match=words):
        chosen([*direct, *counted], counts={"find": 2})
    # Who didn't ask for it is told how many there were.
    found = chosen([*direct, *counted])
    assert Counter(it.task.question_type for it in found.chosen) == {"count": 4}
    assert found.dropped == {"without tools, beyond --direct-share": 4}
    assert len(chosen([*direct, *counted], counts={"find": 2}, direct_share=1.0).chosen) == 6


def test_what_is_not_wanted_is_not_laid_to_the_share():
    direct = [lesson(training_task(n), setting="direct") for n in range(6)]
    agentic = [lesson(training_task(n)) for n in range(10, 16)]
    found = chosen([*direct, *agentic], counts={"find": 4})
    assert len(found.chosen) == 4
    assert found.dropped == {"another of its task, or more than wanted": 8}


@pytest.mark.parametrize("setting", ["agentic", "direct"])
def test_an_episode_with_a_reminder_is_not_learnt(setting):
    plain, other = (
        lesson(training_task(1), setting=setting),
        lesson(training_task(2), setting=setting),
    )
    found = chosen([plain, reminded(other)], direct_share=1.0)
    assert ids(found) == [(plain.task.id, setting)]
    assert found.dropped == {"a call or reply that did nothing": 1}


def test_the_order_of_episodes_does_not_matter():
    lessons = [lesson(training_task(n, answer="A" if n % 2 else "B")) for n in range(9)]
    recipe = {"counts": {"find": 5}, "seed": 3}
    assert ids(chosen(lessons, **recipe)) == ids(chosen(lessons[::-1], **recipe))
    assert ids(chosen(lessons, **recipe)) != ids(chosen(lessons, counts={"find": 5}, seed=4))
