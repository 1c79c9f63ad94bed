from __future__ import annotations

import math
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
from scipy.spatial.transform import Rotation

from probe.world.robot import jaco
from world.robot.urdf import Urdf

ROOT = "j2s6s300_link_base"


def description(assets: Path) -> Path:
    return assets / "robots" / "kinova_j2s6s300" / "kinova_j2s6s300.urdf"


def named(joints: list[float]) -> dict[str, float]:
    return {f"j2s6s300_{name}": angle for name, angle in zip(jaco.JOINTS, joints, strict=True)}


def test_forward_equals_the_vendors_description(assets: Path) -> None:
    urdf = Urdf.read(description(assets))
    rng = np.random.default_rng(0)
    for joints in rng.uniform(-math.pi, math.pi, (1000, 6)):
        expected = urdf.forward(ROOT, "j2s6s300_link_6", named(joints.tolist()))
        actual = jaco.forward(joints)
        assert np.linalg.norm(expected[:3, 3] - actual.position) < 1e-3
        # The maker's last frame looks back from the hand; its y axis is ours.
        turned = np.diag([-1.0, 1.0, -1.0]) @ expected[:3, :3].T @ actual.rotation
        assert math.degrees(Rotation.from_matrix(turned).magnitude()) < 0.1


def test_the_makers_end_effector_lies_ahead_of_the_hand(assets: Path) -> None:
    urdf = Urdf.read(description(assets))
    joints = np.array([0.4, 2.6, 1.3, -0.7, 2.2, 1.1])
    effector = urdf.forward(ROOT, "j2s6s300_end_effector", named(joints.tolist()))
    hand = jaco.forward(joints)
    ahead = hand.apply(np.array([[0.0, 0.0, jaco.HAND_CENTRE]]))[0]
    assert np.linalg.norm(effector[:3, 3] - ahead) < 1e-3
    np.testing.assert_allclose(effector[:3, 2], hand.rotation[:, 2], atol=1e-4)


def test_limits_equal_the_vendors_description(assets: Path) -> None:
    root = ElementTree.parse(description(assets)).getroot()
    for name, limits, torque in zip(jaco.JOINTS, jaco.LIMITS, jaco.TORQUE_LIMIT, strict=True):
        joint = root.find(f"joint[@name='j2s6s300_{name}']")
        assert joint is not None
        assert (joint.attrib["type"] == "continuous") == (limits is None)
        limit = joint.find("limit")
        assert limit is not None
        assert float(limit.attrib["effort"]) == torque
        assert float(limit.attrib["velocity"]) >= jaco.JOINT_SPEED - 1e-9
        if limits is not None:
            stated = [float(limit.attrib[side]) for side in ("lower", "upper")]
            np.testing.assert_allclose(limits, stated, atol=1e-9)


def test_upright_arm_by_hand() -> None:
    # Straight up: all lengths add up, and the forearm's axis stands beside the shoulder's.
    pose = jaco.forward(np.array([0.0, math.pi, math.pi, 0.0, math.pi, 0.0]))
    height = 0.2755 + 0.41 + 0.2073 + 0.1038 + 0.1038
    np.testing.assert_allclose(pose.position, [0.0, -0.0098, height], atol=1e-9)
    np.testing.assert_allclose(pose.rotation[:, 2], [0.0, 0.0, 1.0], atol=1e-9)
