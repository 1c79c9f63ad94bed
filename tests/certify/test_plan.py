from __future__ import annotations

from collections import Counter
from itertools import product

import pytest

from probe.certify.plan import ATTEMPTS, PAIRED, plan
from probe.tasks.task import KINDS, LETTERS, PAIR


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("base", [0, 1000, 2_000_000])
def test_properties_balance_over_120_episodes(kind, base):
    plans = [plan(kind, (base * 120 + episode) * ATTEMPTS) for episode in range(120)]
    letters = dict.fromkeys(PAIR, 60) if kind in PAIRED else dict.fromkeys(LETTERS, 24)
    assert Counter(p.letter for p in plans) == letters
    assert Counter(p.wording for p in plans) == dict.fromkeys(range(20), 6)
    assert Counter(p.removals for p in plans) == {1: 30, 2: 30, 3: 30, 4: 20, 5: 10}
    assert Counter((p.visible, p.hidden) for p in plans) == {
        (v, h): 10 for v in range(4) for h in range(3)
    }
    assert Counter(p.partly for p in plans) == {False: 80, True: 40}


@pytest.mark.parametrize("kind", PAIRED)
def test_what_shows_tells_the_answer_in_half_of_the_pairs(kind):
    plans = [plan(kind, episode * ATTEMPTS) for episode in range(80)]
    both = tuple(product((True, False), repeat=2))
    for letter in PAIR:
        mine = [p for p in plans if p.letter == letter]
        assert Counter(p.cues[:2] for p in mine) == dict.fromkeys(both, 10)
    assert Counter((p.cues[2], p.longer_cover) for p in plans) == dict.fromkeys(both, 20)
    assert sum(p.lighter for p in plans) == 40


def test_all_attempts_of_an_episode_share_a_plan():
    assert len({plan("count", 41_000 + attempt) for attempt in range(ATTEMPTS)}) == 1


def test_types_and_blocks_have_orders_of_their_own():
    letters = {
        tuple(plan(kind, (5 * block + place) * ATTEMPTS).letter for place in range(5))
        for kind in KINDS
        for block in range(10)
    }
    assert len(letters) > 20
