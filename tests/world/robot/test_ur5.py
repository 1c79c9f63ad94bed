from __future__ import annotations

import math
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
from scipy.spatial.transform import Rotation

from probe.world.robot import ur5
from world.robot.urdf import Urdf


def test_forward_equals_the_vendors_description(assets: Path) -> None:
    urdf = Urdf.read(assets / "robots" / "ur5" / "ur5.urdf")
    rng = np.random.default_rng(0)
    for joints in rng.uniform(-math.pi, math.pi, (1000, 6)):
        named = dict(zip((f"{name}_joint" for name in ur5.JOINTS), joints.tolist(), strict=True))
        expected = urdf.forward("base", "tool0", named)
        actual = ur5.forward(joints)
        assert np.linalg.norm(expected[:3, 3] - actual.position) < 1e-3
        turn = Rotation.from_matrix(expected[:3, :3].T @ actual.rotation).magnitude()
        assert math.degrees(turn) < 0.1


def test_limits_equal_the_vendors_description(assets: Path) -> None:
    root = ElementTree.parse(assets / "robots" / "ur5" / "ur5.urdf").getroot()
    for index, name in enumerate(ur5.JOINTS):
        limit = root.find(f"joint[@name='{name}_joint']/limit")
        assert limit is not None
        np.testing.assert_allclose(float(limit.attrib["upper"]), ur5.JOINT_LIMIT[index])
        np.testing.assert_allclose(float(limit.attrib["effort"]), ur5.TORQUE_LIMIT[index])
        np.testing.assert_allclose(float(limit.attrib["velocity"]), ur5.JOINT_SPEED)


def test_stretched_arm_by_hand() -> None:
    # At zero the links lie along -x; wrist 1 and wrist 3 add up along -y.
    pose = ur5.forward(np.zeros(6))
    np.testing.assert_allclose(pose.position, [-0.81725, -0.10915 - 0.0823, 0.089159 - 0.09465])
    np.testing.assert_allclose(pose.rotation[:, 2], [0, -1, 0], atol=1e-12)
