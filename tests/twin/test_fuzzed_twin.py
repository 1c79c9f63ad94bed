"""Commands, most of them wrong, to a twin: its physics never leave the box or pass a limit.

What is measured is the simulated arm, with the simulation's own kinematics; not a plan, and not
what the bridge's checks say.
"""

from __future__ import annotations

import random
from dataclasses import dataclass, field, replace
from typing import Any

import mujoco
import numpy as np
import pytest
from bridges import TOKEN
from fuzzing import fuzz
from raw import connected

from bodies import at, box_item, shelf
from probe.render.renderer import Renderer
from probe.scene.scene import PlacedObject, Scene
from probe.scene.setup import UR5_TABLE, Setup
from probe.station.arms import arm_of, hand_of
from probe.twin.config import twin_config
from probe.twin.flaws import NO_FLAWS
from probe.twin.serving import TwinSettings, listening, twin_of
from probe.types import Array
from probe.world.robot import ur5

HASTE = 5.0
SMALL = replace(UR5_TABLE, name="small", picture_px=256)
BOX = box_item(1, "red box", (0.09, 0.05, 0.06), mass=0.2)

TRAILING = 0.01
"""Metres and radians by which a servo may be beside a plan that is inside its limits."""

OVERSHOOT = 1.1
"""Times its limit that a servo may be fast while it catches up."""


@dataclass
class Seen:
    """Joint angles and speeds in the physics, of every step."""

    joints: list[Array] = field(default_factory=list)
    speeds: list[Array] = field(default_factory=list)

    def __call__(self, joints: Array, speeds: Array) -> None:
        self.joints.append(joints)
        self.speeds.append(speeds)


def watched_points(setup: Setup, joints: Array) -> Array:
    """Tool, fingertip, and where the inner joints are, world, metres, shape (6, 3)."""
    arm, hand = arm_of(setup.mount), hand_of(setup)
    tool = arm.forward(joints)
    reach = hand.pad_reach(hand.max_opening) + hand.pad_half[2]
    tip = tool.apply(np.array([[0.0, 0.0, reach]]))[0]
    frame, origins = setup.mount.base.matrix, []
    for number, angle in enumerate(joints):
        origins.append(frame[:3, 3])
        frame = frame @ ur5.link_transform(number, float(angle))
    return np.array([tool.position, tip, *origins[1:5]])


def worst(seen: Seen, raw: dict[str, Any]) -> dict[str, float]:
    """By how much each kind of limit was passed: metres, radians; of speeds the share."""
    joints, speeds = np.array(seen.joints), np.abs(seen.speeds)
    low, high = (np.array([j[k] for j in raw["joints"]]) for k in ("lower", "upper"))
    moving = np.flatnonzero(speeds.max(axis=1) > 0.05)
    points = np.array([watched_points(SMALL, joints[k]) for k in moving[::4]])
    box = raw["tool_box"]
    away = np.maximum(np.array(box["lower"]) - points, points - np.array(box["upper"]))
    return {
        "range": float(np.maximum(low - joints, joints - high).max()),
        "speed": float((speeds / [j["speed"] for j in raw["joints"]]).max()),
        "box": float(away.max()),
        "moving": float(len(moving)),
    }


def fuzzed(commands: int, seed: int) -> dict[str, float]:
    """What the physics did while a twin was sent so many commands; see worst()."""
    scene = Scene(1, "oak_planks", (PlacedObject(1, BOX.spec.id, at(0.05, 0.05)),), SMALL)
    rng, seen, done = random.Random(seed), Seen(), 0
    settings = TwinSettings(NO_FLAWS, HASTE, views=("front",))
    with (
        Renderer() as renderer,
        twin_of(scene, shelf([BOX]), renderer, settings, seen) as robot,
        listening(robot, TOKEN, "127.0.0.1", 0) as address,
    ):
        # What a blow does to a joint's speed no bridge can limit, and arms hit themselves here.
        driver: Any = robot._driver
        driver._body._world._model.opt.disableflags |= mujoco.mjtDisableBit.mjDSBL_CONTACT
        while done < commands:
            with connected(address) as socket:
                done += fuzz(socket, robot, rng, commands - done)
    return worst(seen, twin_config(SMALL, ("front",), HASTE))


@pytest.mark.slow
def test_no_fuzzed_command_takes_the_physics_beyond_a_limit() -> None:
    found = fuzzed(200, 20)
    assert found["moving"] > 2000
    assert found["range"] < TRAILING
    assert found["box"] < TRAILING
    assert found["speed"] < OVERSHOOT


def test_the_measure_finds_what_is_planted() -> None:
    raw = twin_config(SMALL, ("front",), 1.0)
    home = np.array(SMALL.mount.parked)
    low = home + (0, 1.7, 0, 0, 0, 0)
    quick = np.array([0, 0, 2 * raw["joints"][2]["speed"], 0, 0, 0])
    far = home + (0, 0, 0, 0, 0, 4 * np.pi)
    fine = worst(Seen([home], [quick / 4]), raw)
    assert fine["box"] < 0 and fine["speed"] == 0.5 and fine["range"] < 0
    assert worst(Seen([low], [quick]), raw)["box"] > 0.05
    assert worst(Seen([home], [quick]), raw)["speed"] == 2.0
    assert worst(Seen([far], [quick]), raw)["range"] > 1.0
