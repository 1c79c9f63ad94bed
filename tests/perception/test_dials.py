import subprocess
import sys
from collections.abc import Mapping
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from probe.errors import BadData
from probe.perception.dials import Dials, NoisyDetector, luck
from probe.perception.matching import match
from probe.perception.oracle import NoLabels, Oracle
from probe.perception.things import Thing, Words
from probe.types import Frame, Pose
from tabletops import Block, paint, spec

PLACES = [(u, v) for u in (60, 360, 660) for v in (60, 360, 660)]
BLOCKS = [Block(n, (u, v, u + 119, v + 119)) for n, (u, v) in enumerate(PLACES, start=1)]
SPECS = {b.instance: spec(f"red mug{b.instance}", "red", category="mug") for b in BLOCKS}
GHOST = Words("ghost", "ghost", (), "A ghost.")


def poses(blocks=BLOCKS) -> Mapping[int, Pose]:
    return {b.instance: Pose((b.box[0] / 1000, b.box[1] / 1000, 0.02)) for b in blocks}


def seen(dials: Dials, seed=0, run=0, blocks=BLOCKS, where=None) -> tuple[Thing, ...]:
    at = where or poses(blocks)
    ideal = Ideal(tuple(blocks))
    return NoisyDetector(ideal, dials, lambda: at, seed, run, [GHOST]).detect(ideal.frame)


@cache
class Ideal:
    """The oracle, which looks at the same frame once."""

    def __init__(self, blocks: tuple[Block, ...]) -> None:
        self.frame = paint(blocks)
        self._things = Oracle(SPECS).detect(self.frame)

    def needs_rgb(self, frame: Frame) -> bool:
        return False

    def detect(self, frame: Frame) -> tuple[Thing, ...]:
        assert frame is self.frame
        return self._things


def told(things):
    return [(t.words.name, t.point_px, t.box_px, int(t.mask.sum())) for t in things]


def test_without_errors_it_is_the_oracle():
    assert told(seen(Dials())) == told(Oracle(SPECS).detect(paint(BLOCKS)))


@settings(max_examples=8, deadline=None)
@given(st.integers(0, 10**9), st.integers(0, 9))
def test_asking_again_returns_the_same_errors(seed, run):
    dials = Dials(0.4, 0.4, 0.4, 0.4)
    oracle = NoisyDetector(Oracle(SPECS), dials, poses, seed, run, [GHOST])
    first = told(oracle.detect(paint(BLOCKS)))
    oracle.detect(paint(BLOCKS[:3]))
    assert told(oracle.detect(paint(BLOCKS))) == first
    assert told(seen(dials, seed, run)) == first


def called(things) -> list[str]:
    return [thing.words.called for thing in things]


def test_a_detector_that_tells_kinds_gives_no_name_away_and_all_are_found_by_name():
    things = seen(Dials(general=1.0))
    assert set(called(things)) == {"drinking vessel"}
    assert {thing.words.told_description for thing in things} == {"a drinking vessel, red"}
    for asked in ("drinking vessel", "a drinking vessel, red", "red vessel"):
        found = match(asked, things)
        assert found and found.literal and len(found.others) > 0
    for number in SPECS:
        found = match(f"red mug{number}", things)
        assert found and found.thing.words.name == f"red mug{number}"
    assert set(called(seen(Dials()))) == {spec.name for spec in SPECS.values()}


def test_the_share_of_kinds_is_what_the_dial_says_and_what_is_unnamed_stays_so():
    told_so = [
        it == "drinking vessel"
        for seed in range(30)
        for it in called(seen(Dials(general=0.3), seed))
    ]
    assert np.mean(told_so) == pytest.approx(0.3, abs=4 * np.sqrt(0.21 / len(told_so)))
    parts = [replace(block, share=0.2) for block in BLOCKS]
    assert called(seen(Dials(general=1.0), blocks=parts)) == called(seen(Dials(), blocks=parts))


def test_what_is_made_up_is_told_by_its_kind_too():
    ghosts = [
        it for it in called(seen(Dials(hallucinated=1.0, general=1.0))) if it != "drinking vessel"
    ]
    assert ghosts and set(ghosts) == {"object"}  # no kind has a ghost in it


@pytest.mark.parametrize("rate", [0.2, 0.7])
def test_the_rates_are_what_the_dials_say(rate):
    n = 30 * len(BLOCKS)
    missed = n - sum(len(seen(Dials(missed=rate), seed)) for seed in range(30))
    cut = sum(len(seen(Dials(over=rate), seed)) for seed in range(30)) - n
    made_up = sum(len(seen(Dials(hallucinated=rate), seed)) for seed in range(30)) - n
    tolerance = 4 * np.sqrt(rate * (1 - rate) / n)
    for errors in (missed, cut, made_up):
        assert errors / n == pytest.approx(rate, abs=tolerance)


def test_runs_and_seeds_differ():
    misses = {
        tuple(thing.words.name for thing in seen(Dials(missed=0.5), seed, run))
        for seed in range(6)
        for run in range(6)
    }
    assert len(misses) > 25


def test_one_things_luck_is_no_other_things_business():
    dials = Dials(missed=0.5)
    for seed in range(20):
        every = {t.words.name for t in seen(dials, seed)}
        fewer = {t.words.name for t in seen(dials, seed, blocks=BLOCKS[:4])}
        assert fewer == every & {SPECS[n].name for n in range(1, 5)}


def test_a_creep_draws_nothing_anew_and_a_move_does():
    dials, changed = Dials(missed=0.5), 0
    at = poses()
    crept = {n: replace(p, position=(p.position[0] + 1e-4, *p.position[1:])) for n, p in at.items()}
    moved = {n: replace(p, position=(p.position[0] + 0.05, *p.position[1:])) for n, p in at.items()}
    for seed in range(10):
        assert told(seen(dials, seed, where=crept)) == told(seen(dials, seed))
        changed += told(seen(dials, seed, where=moved)) != told(seen(dials, seed))
    assert changed > 5


def test_a_cut_loses_nothing():
    halves = seen(Dials(over=1.0))
    assert len(halves) == 2 * len(BLOCKS)
    whole = np.sum([thing.mask for thing in halves], axis=0)
    assert np.array_equal(whole, (paint(BLOCKS).labels != 0).astype(int))
    assert all(thing.words.name for thing in halves)


def test_neighbours_become_one_and_lone_things_stay():
    pair = [Block(1, (100, 100, 299, 299)), Block(2, (300, 100, 350, 299)), BLOCKS[8]]
    things = seen(Dials(under=1.0), blocks=pair)
    assert [thing.words.name for thing in things] == ["red mug1", "red mug9"]
    assert np.count_nonzero(things[0].mask) == 251 * 200


def test_everything_missed_and_everything_made_up():
    assert seen(Dials(missed=1.0)) == ()
    things = seen(Dials(hallucinated=1.0))
    ghosts = [thing for thing in things if thing.words == GHOST]
    assert len(ghosts) == len(BLOCKS) == len(things) - len(ghosts)
    labels = paint(BLOCKS).labels
    assert labels is not None and not any(labels[ghost.mask].any() for ghost in ghosts)


def test_what_is_made_up_is_called_the_same_where_the_list_has_more_objects():
    """But for the few that are called one of these."""
    rumours = [Words(f"thing {n}", "thing", (), "A thing.") for n in range(200)]
    more = [Words(f"more {n}", "more", (), "More.") for n in range(10)]
    ideal, same, n = Ideal(tuple(BLOCKS)), 0, 0
    for seed in range(30):
        names = [
            [it.words.name for it in NoisyDetector(
                ideal, Dials(hallucinated=1.0), poses, seed, 0, known).detect(ideal.frame)]
            for known in (rumours, [*more[:5], *rumours, *more[5:]])
        ]  # fmt: skip
        same += sum(one == other for one, other in zip(*names, strict=True))
        n += len(names[0])
    assert same / n > 0.9


def test_luck_is_the_same_in_another_process():
    line = "from probe.perception.dials import luck; print(luck('7/0/3/mug/missed'))"
    other = subprocess.run(
        [sys.executable, "-c", line], capture_output=True, text=True, check=True
    ).stdout
    assert float(other) == luck("7/0/3/mug/missed")


@given(st.text(max_size=30))
def test_luck_is_a_probability(state):
    assert 0 <= luck(state) < 1


def test_rates_out_of_bounds_are_refused():
    with pytest.raises(BadData, match="--dials.missed: 1.5 is no rate"):
        Dials(missed=1.5)


def test_frames_of_a_real_camera_are_refused():
    frame = replace(paint(BLOCKS), labels=None)
    with pytest.raises(NoLabels):
        NoisyDetector(Oracle(SPECS), Dials(missed=0.5), poses, 0).detect(frame)
