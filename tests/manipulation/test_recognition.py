from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
import pytest

from manipulation.views import Block, view
from probe.manipulation.looking import tracked
from probe.manipulation.recognition import recognised
from probe.types import Array, Frame

RED, BLUE, TABLE = (200, 40, 30), (30, 60, 190), (150, 140, 130)
Painted = tuple[Block, tuple[int, int, int]]

STANDING: Painted = (Block(-0.05, 0.0, (0.04, 0.05, 0.12)), RED)
LYING: Painted = (Block(0.06, 0.02, (0.12, 0.05, 0.04)), RED)
LIKE_IT: Painted = (Block(-0.02, 0.0, (0.04, 0.05, 0.12)), BLUE)
WAY = np.array([0.06, 0.0, 0.0])


def coloured(things: Sequence[Painted]) -> tuple[Frame, list[Array]]:
    frame, masks = view([block for block, _ in things])
    rgb = np.empty((*frame.depth.shape, 3), np.uint8)
    rgb[:] = TABLE
    for mask, (_, colour) in zip(masks, things, strict=True):
        rgb[mask] = colour
    return replace(frame, rgb=rgb), masks


def overlap(one: Array, other: Array) -> float:
    return (one & other).sum() / (one | other).sum()


def test_what_fell_over_is_found_by_its_colour() -> None:
    before, (mask,) = coloured([STANDING])
    after, (expected,) = coloured([LYING])
    found = recognised(before, after, mask, WAY, tracked(before, after, mask, WAY))
    assert found is not None and overlap(found.mask, expected) > 0.8
    assert found.shift[0] == pytest.approx(0.11, abs=0.01)


def test_something_else_of_its_shape_is_not_taken_for_it() -> None:
    away: Painted = (Block(-0.05, -0.15, LIKE_IT[0].size), BLUE)
    before, (mask, _) = coloured([STANDING, away])
    after, (expected, other) = coloured([LYING, LIKE_IT])
    by_shape = tracked(before, after, mask, WAY)
    assert by_shape is not None and overlap(by_shape.mask, other) > 0.5, "shape alone errs"
    found = recognised(before, after, mask, WAY, by_shape)
    assert found is not None and overlap(found.mask, expected) > 0.8


def test_what_is_gone_is_not_found() -> None:
    before, (mask, _) = coloured([STANDING, LIKE_IT])
    after, _ = coloured([LIKE_IT])
    assert recognised(before, after, mask, WAY, None) is None
