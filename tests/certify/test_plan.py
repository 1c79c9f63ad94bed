from __future__ import annotations

from collections import Counter

import pytest

from probe.certify.plan import ATTEMPTS, plan
from probe.tasks.task import KINDS


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("base", [0, 1000, 2_000_000])
def test_properties_balance_over_sixty_episodes(kind, base):
    plans = [plan(kind, (base * 60 + episode) * ATTEMPTS) for episode in range(60)]
    assert set(Counter(p.letter for p in plans).values()) == {12}
    assert Counter((p.visible, p.hidden) for p in plans) == {
        (v, h): 5 for v in range(4) for h in range(3)
    }
    assert Counter(p.partly for p in plans) == {False: 40, True: 20}


def test_all_attempts_of_an_episode_share_a_plan():
    assert len({plan("count", 41_000 + attempt) for attempt in range(ATTEMPTS)}) == 1


def test_types_and_blocks_have_orders_of_their_own():
    letters = {
        tuple(plan(kind, (5 * block + place) * ATTEMPTS).letter for place in range(5))
        for kind in KINDS
        for block in range(10)
    }
    assert len(letters) > 20
