"""What a try is made from, what its task bears, and the way back with the salt alone."""

from __future__ import annotations

import re
from collections import Counter
from dataclasses import replace

import pytest

from probe.generation.attempt import Attempt, origins
from probe.generation.build_folder import TaskSlot
from probe.generation.plan import plan, plan_of
from probe.generation.result import TaskCandidate
from probe.generation.salt import Salt
from probe.generation.task_generator import generator_of
from probe.scene.setup import ROOM_TABLE
from probe.tasks.suite import Suite
from probe.tasks.suite_file import packaged_suite
from probe.tasks.task import LETTERS, PAIR, QUESTION_TYPES, Task
from probe.verification.salt import salt_problems
from task_examples import FIND

ONE, OTHER = Salt(bytes(range(32))), Salt(bytes(range(1, 33)))
V1 = packaged_suite("v1")


def test_public_tries_are_what_they_were():
    for task in V1.tasks:
        attempt = Attempt.of_task(task)
        assert attempt.rules == 2
        assert (attempt.id, attempt.seed, attempt.bears) == (task.id, task.seed, task.seed)
        assert attempt.plan == replace(plan(task.question_type, task.seed), rules=2)
        assert attempt.plan.letter == task.answer


@pytest.mark.parametrize("question_type", QUESTION_TYPES)
def test_salted_plans_balance_as_public_ones_do(question_type):
    plans = [plan_of(question_type, episode, ONE) for episode in range(120)]
    paired = question_type in ("compare", "size")
    letters = dict.fromkeys(PAIR, 60) if paired else dict.fromkeys(LETTERS, 24)
    assert Counter(p.letter for p in plans) == letters
    assert Counter(p.wording for p in plans) == dict.fromkeys(range(20), 6)
    for turn in generator_of(question_type).turns:
        found = Counter(turn.of(p) for p in plans)
        assert found == {
            value: 120 * times // len(turn.values) for value, times in Counter(turn.values).items()
        }
    # Over any number of tasks, not whole blocks alone.
    firsts = Counter(p.letter for p in plans[:27])
    assert paired or max(firsts.values()) - min(firsts.values()) == 1


def test_all_that_is_planned_depends_on_the_salt():
    for number in range(4):
        public, one, other = (
            [
                plan_of(question_type, episode, salt)
                for question_type in QUESTION_TYPES
                for episode in range(60)
            ]
            for salt in (None, ONE, OTHER)
        )
        what = (
            lambda p: p.letter,
            lambda p: p.wording,
            lambda p: p.places.get("cues"),
            lambda p: p.places.get("count"),
        )[number]
        ways = {tuple(map(what, plans)) for plans in (public, one, other)}
        assert len(ways) == 3


def test_names_are_wide_and_differ_by_salt_and_purpose():
    place = TaskSlot("count", 3)
    one, other = (Attempt(place, 2, salt) for salt in (ONE, OTHER))
    assert re.fullmatch(r"count-[0-9a-f]{16}", one.id)
    numbers = {one.seed, one.bears, other.seed, other.bears}
    assert len(numbers) == 4 and all(number > 2**64 for number in numbers)
    tries = [
        Attempt(TaskSlot(k, e), n, ONE) for k in QUESTION_TYPES for e in range(40) for n in range(5)
    ]
    for names in (
        {it.id for it in tries},
        {it.seed for it in tries},
        {it.bears for it in tries},
    ):
        assert len(names) == len(tries)


def private(attempt: Attempt) -> Task:
    """A task as a try would name it."""
    return replace(
        FIND,
        id=attempt.id,
        seed=attempt.bears,
        scene=replace(FIND.scene, seed=attempt.bears),
        answer=attempt.plan.letter,
    )


def test_a_private_task_is_seen_in_the_room_that_it_was_checked_in():
    for number in range(12):
        attempt = Attempt(TaskSlot("find", number), 0, ONE)
        made = replace(FIND, scene=replace(FIND.scene, seed=attempt.seed, setup=ROOM_TABLE))
        named = attempt.named(TaskCandidate(made)).task
        assert named.scene.seed != made.scene.seed
        assert named.viewpoint == made.viewpoint
        assert named.viewpoint.lighting.name.startswith("day_room_")


TRIES = [Attempt(TaskSlot("find", episode), 7 * episode % 40, ONE) for episode in range(12)]
TASKS = sorted(map(private, TRIES), key=lambda task: task.id)
SUITE = Suite("private", tuple(TASKS), {}, ONE.commitment)


def test_the_salt_leads_back_to_every_try_and_another_to_none():
    assert origins(TASKS, ONE) == {it.id: it for it in TRIES}
    assert list(salt_problems(SUITE, origins(TASKS, ONE))) == []
    assert origins(TASKS, OTHER) == origins(V1.tasks, ONE) == {}


@pytest.mark.parametrize(
    ("tasks", "problem"),
    [
        (TASKS[::-1], "order of their ids"),
        ([replace(TASKS[0], scene=FIND.scene), *TASKS[1:]], "bears another seed"),
        ([replace(TASKS[0], seed=TASKS[1].seed), *TASKS[1:]], "doesn't come from"),
        ([replace(TASKS[0], question_type="reduce"), *TASKS[1:]], "doesn't come from"),
        (
            [replace(TASKS[0], answer="A" if TASKS[0].answer != "A" else "B"), *TASKS[1:]],
            "were planned",
        ),
        ([replace(TASKS[0], id="find-0000000000000000"), *TASKS[1:]], "doesn't come from"),
    ],
)
def test_what_doesnt_follow_from_the_salt_is_told(tasks, problem):
    told = list(salt_problems(replace(SUITE, tasks=tuple(tasks)), origins(tasks, ONE)))
    assert any(problem in line for line in told)
