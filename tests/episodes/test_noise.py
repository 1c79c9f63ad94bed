"""Noise depends on what is done, never on when, and displaces the hand, not the outcome."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
import pytest

from probe.episodes.noise import NO_NOISE, HandErrors, Noise
from probe.scene.setup import UR5_TABLE
from probe.station.gripper import Gripper
from probe.station.offset_station import OffsetStation
from probe.station.station import Arm as UrArm
from probe.station.station import Hand
from probe.station.ur5 import Ur5
from probe.types import Frame, Pose

NOISE = Noise(grasp=0.01, push=0.02)
LABELS = np.zeros((8, 8), np.int32)
LABELS[:4, :4], LABELS[4:, 4:] = 1, 2
FRAME = Frame(UR5_TABLE.top.camera(8), np.ones((8, 8), np.float32), labels=LABELS)


@dataclass
class Arm:
    """A station that goes wherever it is sent and remembers where that was."""

    arm: UrArm = field(default_factory=Ur5)
    hand: Hand = field(default_factory=Gripper)
    paths: list[np.ndarray] = field(default_factory=list)

    def joints(self):
        return self.paths[-1][-1] if self.paths else self.arm.parked

    def follow(self, path):
        self.paths.append(path)
        return True

    def grip(self, opening):
        return opening

    def observe(self, *, rgb):
        return FRAME

    def look_into_basket(self, *, rgb):
        return FRAME

    def wait(self, seconds):
        pass


def errors(*attempts, noise=NOISE, seed=5, run=0):
    """Errors of the hand in attempts, each ("grasp" or "push", instance)."""
    hand = HandErrors(noise, seed, run)
    drawn = [hand.draw(tool, FRAME, instance == LABELS) for tool, instance in attempts]
    return [error for error in drawn if error is not None]


def test_the_same_act_has_the_same_error_whatever_came_before():
    (alone,) = errors(("grasp", 2))
    later = errors(("push", 2), ("grasp", 1), ("grasp", 1), ("grasp", 2))[-1]
    assert later == pytest.approx(alone, abs=1e-9)
    assert np.abs(alone[:2]).max() > 1e-4 and alone[2] == pytest.approx(0, abs=1e-9)


def test_a_retry_another_object_another_run_and_another_seed_draw_again():
    first, again = errors(("grasp", 1), ("grasp", 1))
    others = [
        again,
        errors(("grasp", 2))[0],
        errors(("grasp", 1), run=1)[0],
        errors(("grasp", 1), seed=6)[0],
        errors(("push", 1))[0] / 2,
    ]
    assert all(np.abs(other - first).max() > 1e-5 for other in others)


def test_without_noise_the_hand_goes_where_it_is_sent():
    assert errors(("grasp", 1), ("push", 2), noise=NO_NOISE) == []


def test_errors_are_as_large_as_the_dial_says():
    drawn = np.array([errors(("grasp", 1), seed=seed)[0][:2] for seed in range(300)])
    assert drawn.std(axis=0) == pytest.approx([0.01, 0.01], rel=0.15)
    assert np.abs(drawn.mean(axis=0)).max() < 0.002


def test_an_offset_hand_believes_to_be_where_it_was_sent_and_parks_well():
    real = Arm()
    station = OffsetStation(real, np.array([0.01, -0.02, 0.0]))
    goal = station.arm.inverse(Pose((0.05, 0.0, 0.25), (0.0, 1.0, 0.0, 0.0)))[0]
    assert station.follow(goal[None])
    reached = np.array(station.arm.forward(real.joints()).position)
    assert reached == pytest.approx([0.06, -0.02, 0.25], abs=1e-6)
    assert station.joints() == pytest.approx(goal)
    station.follow(station.arm.parked[None])
    assert real.joints() == pytest.approx(station.arm.parked)
