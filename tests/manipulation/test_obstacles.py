"""Hand and arm keep apart on the way."""

from pathlib import Path

import numpy as np
import pytest

from probe.manipulation.handshape import HandShape
from probe.manipulation.obstacles import Obstacles
from probe.manipulation.terrain import Terrain, survey
from probe.render.renderer import Renderer
from probe.scene.setup import UR5_TABLE
from probe.scene.setup_file import read_setup
from probe.station.arms import arm_of, hand_of
from shapes import grey_table

MET = {
    0.0682: (-0.7852, -1.9292, -0.1904, 0.3659, -1.4595, -0.5052),
    0.1092: (-0.8561, -1.8795, -0.1852, 0.4164, -1.5685, 0.3326),
    0.1285: (-0.7121, -1.9375, 0.0704, 0.4622, -1.5713, -0.1599),
}
"""Where the simulated arm was held because a finger met the upper arm, by the hand's opening."""


JACO = read_setup(Path(__file__).parents[2] / "examples" / "setups" / "jaco.json")


@pytest.fixture(scope="module")
def empty() -> Terrain:
    with Renderer() as renderer:
        renderer.load({}, grey_table())
        return survey(renderer.draw([], UR5_TABLE.camera(), rgb=False), UR5_TABLE)


@pytest.mark.parametrize(("opening", "joints"), MET.items())
def test_a_finger_does_not_come_upon_the_upper_arm(empty, opening, joints):
    points = HandShape(hand_of(UR5_TABLE)).whole(opening)[::3]
    assert not Obstacles.of(arm_of(UR5_TABLE.mount), empty).free_at(np.array(joints), points)


@pytest.mark.parametrize("setup", [UR5_TABLE, JACO], ids=["ur5", "jaco"])
def test_a_parked_arm_is_apart_from_its_hand_however_that_turns(empty, setup):
    arm, shape = arm_of(setup.mount), HandShape(hand_of(setup))
    obstacles = Obstacles.of(arm, empty)
    for turn in np.linspace(-3, 3, 7):
        joints = arm.parked + turn * np.eye(len(arm.parked))[-1]
        for opening in (0.0, hand_of(setup).max_opening):
            assert obstacles.unfolded(joints, shape.whole(opening), 0.01)
