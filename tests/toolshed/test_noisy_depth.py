"""Cameras that err: what nobody touched is untouched, and what moved by 2 cm has moved."""

from dataclasses import replace

import pytest

from noisy import NoisyStation
from probe.changes.compare import compare
from probe.perception.oracle import Oracle
from probe.perception.segmenter import Segmenter
from probe.scene.setup import UR5_TABLE
from probe.toolshed.bystanders import bystander_words
from probe.toolshed.handles import Handles
from probe.toolshed.refusals import StaleHandle
from probe.toolshed.view import CurrentView
from tabletops import Block, spec

SMALL = replace(UR5_TABLE, picture_px=256)
TWO_CM = round(0.02 * SMALL.picture_px / SMALL.view_size)
SPECS = {1: spec("red mug", "red"), 2: spec("blue book", "blue"), 3: spec("white ball", "white")}
BLOCKS = [
    Block(1, (25, 25, 55, 55)),
    Block(2, (125, 75, 200, 175), height=0.02, colour=(30, 60, 150)),
    Block(3, (150, 112, 170, 132), height=0.08, colour=(240, 240, 240)),
]
ON = {1: (40, 40), 2: (130, 80), 3: (160, 120)}
"""A pixel of each block."""

LOOKS = 40


def view(station, exact):
    detector = Oracle(SPECS) if exact else Segmenter()
    return CurrentView(station, detector, SMALL.basket, guessed=not exact)


def stays_untouched(sigma, exact):
    station = NoisyStation(BLOCKS, SMALL, sigma)
    first, handles = view(station, exact), Handles(detected=exact)
    names = [handles.issue(thing, first.frame) for thing in first.things]
    assert len(names) == len(BLOCKS)
    for _ in range(LOOKS):
        later = view(station, exact)
        assert 0 < later.coloured.depth_noise < sigma / 2
        for name in names:
            handles.resolve(name, later)
        changes = compare(first.look, later.look)
        assert {change.fate for change in changes.things} == {"stayed"}
        assert not bystander_words(changes, changes.things[0].before, {})


@pytest.mark.parametrize("sigma", [pytest.param(0.001, marks=pytest.mark.slow), 0.003])
def test_an_untouched_table_stays_untouched_in_every_look(sigma):
    stays_untouched(sigma, exact=True)


@pytest.mark.slow
@pytest.mark.parametrize("sigma", [0.001, 0.002, 0.003])
def test_so_it_does_where_outlines_are_guessed(sigma):
    stays_untouched(sigma, exact=False)


@pytest.mark.parametrize("exact", [True, False])
@pytest.mark.parametrize("sigma", [0.001, 0.003])
@pytest.mark.parametrize("which", [1, 2, 3])
def test_a_thing_that_moved_by_2_cm_is_noticed(which, sigma, exact):
    station = NoisyStation(BLOCKS, SMALL, sigma)
    first, handles = view(station, exact), Handles(detected=exact)
    u, v = ON[which]
    mine = next(thing for thing in first.things if thing.mask[v, u])
    name = handles.issue(mine, first.frame)
    before = first.look
    station.move(which, TWO_CM)
    later = view(station, exact)
    with pytest.raises(StaleHandle):
        handles.resolve(name, later)
    changes = compare(before, later.look).things
    assert {c.fate for c in changes if c.before.thing is mine} == {"moved"}
