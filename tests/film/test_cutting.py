"""Which moments a film shows, and how fast."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from probe.episodes.record import EpisodeRecord, TableState
from probe.episodes.turns import Call, Question
from probe.film.cutting import FPS, SLOW, FilmShot, cut
from probe.film.footage import FilmedCall, Footage
from probe.film.watched_world import SAMPLE_TIME, TableMoment
from probe.toolshed.result import ToolResult
from task_examples import FIND, SCENE


def footage(joint: list[float], opening: list[float]) -> Footage:
    """One call during which a joint and the pads move so."""
    moments = tuple(
        TableMoment(number * SAMPLE_TIME, np.array([angle, 0, 0, 0, 0, 0]), gap, SCENE.objects)
        for number, (angle, gap) in enumerate(zip(joint, opening, strict=True))
    )
    question = Question("Which?", ())
    state = TableState(SCENE, (0.0,) * 6)
    record = EpisodeRecord("t", "me", 0, question, state, (), None, "stopped")
    calls = (FilmedCall(Call("grasp_and_remove"), ToolResult("Done."), 0, len(moments) - 1),)
    return Footage(FIND, record, question, moments, calls)


def moving(shots: list[FilmShot]) -> list[FilmShot]:
    return [shot for shot in shots if shot.speed is not None]


@pytest.mark.parametrize("speed", [1.0, 2.0, 0.5])
def test_a_motion_lasts_as_long_as_its_speed_says(speed: float) -> None:
    count = 500
    shots = moving(cut(footage(list(np.linspace(0, 2, count)), [0.1] * count), speed, [(9, 9)]))
    assert {shot.speed for shot in shots} == {speed}
    seconds = (count - 1) * SAMPLE_TIME / speed
    assert len(shots) / FPS == pytest.approx(seconds, abs=0.1)


def test_fingers_close_slowly_and_open_as_fast_as_the_arm_moves() -> None:
    count = 200
    closing = list(np.linspace(0.1, 0.0, count))
    shots = moving(cut(footage([0.0] * (2 * count), closing + closing[::-1]), 2.0, [(9, 9)]))
    slow = [shot for shot in shots if shot.speed == SLOW]
    after = 0.35 / SAMPLE_TIME
    assert len(slow) / FPS == pytest.approx((count + after) * SAMPLE_TIME / SLOW, abs=0.15)
    assert all(shot.moment < count + after for shot in slow)
    assert {shot.speed for shot in shots if shot.moment > count + after} == {2.0}


def test_a_quick_grip_is_seen() -> None:
    """A tenth of a second of closing, as in a grasp, is shown for over a second and a half."""
    grip = [0.1] * 100 + [0.097, 0.094, 0.091, 0.088, 0.085] + [0.085] * 100
    shots = moving(cut(footage([0.0] * len(grip), grip), 3.0, [(9, 9)]))
    slow = [shot for shot in shots if shot.speed == SLOW]
    assert 1.4 < len(slow) / FPS < 1.8


def test_fingers_of_a_parked_arm_close_on_nothing_and_no_slower_than_the_arm_moves() -> None:
    closing = list(np.linspace(0.1, 0.0, 100))
    filmed = footage([0.0] * 100, closing)
    parked = FIND.setup.mount.parked
    at_rest = tuple(replace(moment, joints=np.array(parked)) for moment in filmed.moments)
    shots = moving(cut(replace(filmed, moments=at_rest), 1.0, [(9, 9)]))
    assert {shot.speed for shot in shots} == {1.0}
    assert len(shots) / FPS == pytest.approx(100 * SAMPLE_TIME, abs=0.1)


def test_rest_is_cut() -> None:
    turn = list(np.linspace(0, 1, 100))
    shots = moving(
        cut(footage(turn + [1.0] * 2000 + [1 + a for a in turn], [0.1] * 2200), 1.0, [(9, 9)])
    )
    assert len(shots) / FPS < 200 * SAMPLE_TIME + 1.0
    assert any(shot.moment > 2150 for shot in shots)


def test_moments_never_go_back_and_captions_stand_longer_if_they_are_longer() -> None:
    shots = cut(footage(list(np.linspace(0, 1, 100)), [0.1] * 100), 1.0, [(10, 100)])
    assert [shot.moment for shot in shots] == sorted(shot.moment for shot in shots)
    before, after = (shot for shot in shots if shot.call == 0 and shot.speed is None)
    assert (before.told, after.told) == (False, True)
    assert after.frames > before.frames >= FPS


def test_an_episode_in_which_nothing_moves_is_stills_alone() -> None:
    shots = cut(footage([0.0], [0.1]), 1.0, [(10, 100)])
    assert [(shot.moment, shot.speed) for shot in shots] == [(0, None)] * 3
