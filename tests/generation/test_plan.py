from __future__ import annotations

from bisect import bisect_left
from collections import Counter
from collections.abc import Callable, Mapping
from itertools import product

import pytest

from probe.generation.in_view import is_open
from probe.generation.plan import ATTEMPTS, PAIRED, block_of, plan, plan_of
from probe.generation.task_plan import CROSSED, MORE_CUES, TaskPlan
from probe.question_types.count.generator import INSTANCES, TO_SIX, instances
from probe.question_types.find.generator import PARTLY_SEEN
from probe.question_types.reduce.generator import REMOVALS
from probe.question_types.size.generator import LIGHTER
from probe.tasks.task import LETTERS, PAIR, QUESTION_TYPES


@pytest.mark.parametrize("question_type", QUESTION_TYPES)
@pytest.mark.parametrize("base", [0, 1000, 2_000_000])
def test_properties_balance_over_120_episodes(question_type, base):
    plans = [plan(question_type, (base * 120 + episode) * ATTEMPTS) for episode in range(120)]
    letters = dict.fromkeys(PAIR, 60) if question_type in PAIRED else dict.fromkeys(LETTERS, 24)
    assert Counter(p.letter for p in plans) == letters
    assert Counter(p.wording for p in plans) == dict.fromkeys(range(20), 6)
    if question_type == "reduce":
        assert Counter(map(REMOVALS.of, plans)) == {1: 30, 2: 30, 3: 30, 4: 20, 5: 10}
    if question_type == "count":
        assert Counter(map(INSTANCES.of, plans)) == {(v, h): 10 for v in range(4) for h in range(3)}
    if question_type == "find":
        assert Counter(map(PARTLY_SEEN.of, plans)) == {False: 80, True: 40}


@pytest.mark.parametrize("question_type", PAIRED)
def test_what_shows_tells_the_answer_in_half_of_the_pairs(question_type):
    plans = [plan(question_type, episode * ATTEMPTS) for episode in range(80)]
    both = tuple(product((True, False), repeat=2))
    for letter in PAIR:
        mine = [p for p in plans if p.letter == letter]
        assert Counter(CROSSED.of(p)[1:] for p in mine) == dict.fromkeys(both, 10)
    assert Counter(map(MORE_CUES.of, plans)) == dict.fromkeys(both, 20)
    if question_type == "size":
        assert sum(map(LIGHTER.of, plans)) == 40


@pytest.mark.parametrize("question_type", QUESTION_TYPES)
@pytest.mark.parametrize("number", [3, 50_001])
def test_a_block_is_even_in_all_that_its_type_is_planned_by(question_type, number):
    episodes = range(number * 20, number * 140)
    start = episodes[bisect_left(episodes, number, key=lambda e: block_of(question_type, e * 1000))]
    length = next(
        n for n in range(1, 121) if block_of(question_type, (start + n) * 1000 + 999) != number
    )
    plans = [plan(question_type, (start + n) * ATTEMPTS) for n in range(length)]

    def even(what: Callable[[TaskPlan], object], shares: Mapping[object, float]) -> bool:
        return Counter(map(what, plans)) == {key: length * share for key, share in shares.items()}

    assert even(lambda p: p.wording, dict.fromkeys(range(20), 1 / 20))
    if question_type in PAIRED:
        cues = product(PAIR, *[(True, False)] * 2)
        assert even(lambda p: (p.letter, *CROSSED.of(p)[1:]), dict.fromkeys(cues, 1 / 8))
        return
    assert even(lambda p: p.letter, dict.fromkeys(LETTERS, 1 / 5))
    if question_type == "count":
        assert even(TO_SIX.of, dict.fromkeys(product(range(5), range(3)), 1 / 15))
        assert even(INSTANCES.of, dict.fromkeys(product(range(4), range(3)), 1 / 12))
    if question_type == "find":
        assert even(PARTLY_SEEN.of, {False: 2 / 3, True: 1 / 3})
    if question_type == "reduce":
        assert even(REMOVALS.of, {1: 1 / 4, 2: 1 / 4, 3: 1 / 4, 4: 1 / 6, 5: 1 / 12})


def test_counts_go_to_six_by_the_new_rules_alone():
    newer, older = ([plan_of("count", e, rules=rules) for e in range(180)] for rules in (3, 2))
    hidden = Counter(instances(p) for p in newer if not is_open(p))
    assert max(map(sum, hidden)) == 6 and set(hidden) == set(product(range(5), range(3)))
    assert all(instances(p)[1] == 0 for p in newer if is_open(p))
    assert Counter(map(instances, older)) == dict.fromkeys(product(range(4), range(3)), 15)


def test_all_attempts_of_an_episode_share_a_plan():
    plans = [plan("count", 41_000 + attempt) for attempt in range(ATTEMPTS)]
    assert all(each == plans[0] for each in plans)


def test_types_and_blocks_have_orders_of_their_own():
    letters = {
        tuple(plan(question_type, (5 * block + place) * ATTEMPTS).letter for place in range(5))
        for question_type in QUESTION_TYPES
        for block in range(10)
    }
    assert len(letters) > 20
