from __future__ import annotations

import numpy as np
import pytest

from manipulation.views import Block, view
from probe.manipulation.looking import still_there, tracked

BLOCK = Block(0.02, 0.05, (0.09, 0.05, 0.06))
OTHER = Block(-0.1, 0.0, (0.05, 0.05, 0.05))


def overlap(a, b) -> float:
    return (a & b).sum() / (a | b).sum()


def test_what_stays_is_still_there_and_what_goes_is_not() -> None:
    before, (mask, _) = view([BLOCK, OTHER])
    assert still_there(before, view([BLOCK, OTHER])[0], mask) == 1.0
    assert still_there(before, view([OTHER])[0], mask) < 0.05


@pytest.mark.parametrize(("dx", "dy"), [(0.0, 0.0), (0.012, -0.007), (-0.03, 0.02)])
def test_a_thing_that_slid_is_found(dx: float, dy: float) -> None:
    before, (mask, _) = view([BLOCK, OTHER])
    after, (expected, _) = view([Block(BLOCK.x + dx, BLOCK.y + dy, BLOCK.size), OTHER])
    found = tracked(before, after, mask)
    assert found is not None and overlap(found.mask, expected) > 0.85
    assert found.shift == pytest.approx([dx, dy, 0.0], abs=0.002)


@pytest.mark.parametrize("dx", [0.02, 0.07, 0.15])
def test_a_thing_that_was_pushed_is_found_where_it_stopped(dx: float) -> None:
    before, (mask, _) = view([BLOCK, OTHER])
    after, (expected, _) = view([Block(BLOCK.x + dx, BLOCK.y + 0.01, BLOCK.size), OTHER])
    found = tracked(before, after, mask, np.array([0.15, 0.0, 0.0]))
    assert found is not None and overlap(found.mask, expected) > 0.85
    assert found.shift == pytest.approx([dx, 0.01, 0.0], abs=0.003)


def test_a_thing_that_is_gone_is_not_taken_for_its_like() -> None:
    twin = Block(BLOCK.x - 0.02, BLOCK.y + 0.055, BLOCK.size)
    before, (mask, _) = view([BLOCK, twin])
    assert tracked(before, view([twin])[0], mask) is None


def test_an_empty_mask_is_not_found() -> None:
    frame, (mask, _) = view([BLOCK, OTHER])
    assert tracked(frame, frame, mask & False) is None
