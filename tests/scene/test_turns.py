"""Who leads is drawn first; where nobody does, every draw is as it was."""

from __future__ import annotations

import numpy as np

from probe.assets.spec import ObjectSpec
from probe.scene.sampling import draw_objects
from probe.scene.turns import in_turn, nobody


def things(count: int) -> list[ObjectSpec]:
    return [
        ObjectSpec(
            f"t{n}", f"thing {n}", f"kind {n}", ("red",), "A thing.", 0.1, 0.5,
            (0.05, 0.05, 0.05), False, "own" if n % 4 == 0 else "procedural", "CC0-1.0", "test",
        )
        for n in range(count)
    ]  # fmt: skip


def test_nobody_leads_and_the_order_is_a_plain_permutation():
    some = things(20)
    expected = [some[n] for n in np.random.default_rng(3).permutation(20)]
    assert in_turn(some, nobody, np.random.default_rng(3)) == expected


def test_those_that_lead_come_first_in_an_order_of_their_own():
    some = things(20)
    drawn = in_turn(some, lambda one: one.origin == "own", np.random.default_rng(3))
    assert [one.origin for one in drawn] == ["own"] * 5 + ["procedural"] * 15
    orders = {
        tuple(x.id for x in in_turn(some, lambda one: one.origin == "own", generator)[:5])
        for generator in map(np.random.default_rng, range(20))
    }
    assert len(orders) > 10


def test_a_table_has_those_that_lead_and_others_beside_them():
    drawn = draw_objects(things(20), 8, np.random.default_rng(1), lambda one: one.origin == "own")
    assert sum(one.origin == "own" for one in drawn) == 5 and len(drawn) == 8
