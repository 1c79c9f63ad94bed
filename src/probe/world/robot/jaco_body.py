"""The Jaco j2s6s300's body: its links, servos and limits. Knows no engine and no fingers.

Masses and centres of mass: the maker's ROS description. Radii and lengths of the housings:
measured on its shapes, enclosing them to 10 mm. The joints' armatures are an estimate: the maker
tells nothing of its rotors.
"""

from __future__ import annotations

from probe.types import Vector3
from probe.world.robot import jaco
from probe.world.robot.arm_body import ArmBody, Hinge, Link, housing
from probe.world.robot.solids import BLACK, GREY, SILVER, Cylinder

_STIFFNESS = (6000.0, 6000.0, 4000.0, 1000.0, 1000.0, 1000.0)
"""Servo stiffness, Nm/rad."""

_ARMATURE = (0.5, 0.5, 0.4, 0.12, 0.12, 0.12)
"""Inertia of motor and gears at the joint, kg m^2."""

_LARGE, _SMALL = 0.0412, 0.032
"""Radii of the large and the small joint housings, metres."""

HAND_BODY = (0.05, 0.121)
"""Radius and length of the hand without its fingers, metres."""


def _tube(start: Vector3, end: Vector3, radius: float) -> Cylinder:
    """The carbon part of a link."""
    return Cylinder(start, end, radius, BLACK)


_BASE = (
    housing(2, 0.0, 0.145, _LARGE, colour=BLACK),
    housing(2, 0.145, 0.1568, 0.0444, colour=SILVER),
)

_LINKS = (
    Link(
        "shoulder",
        0.7477,
        (0.0, 0.002, 0.0583),
        (0.04, 0.16, 2),
        (
            housing(2, 0.035, 0.107, _LARGE, colour=BLACK),
            housing(2, 0.107, 0.1188, 0.0444, colour=SILVER),
            housing(1, -0.001, 0.041, _LARGE),
        ),
    ),
    Link(
        "upper_arm",
        0.99,
        (0.2065, 0.0, -0.0116),
        (0.035, 0.41, 0),
        (
            housing(2, -0.0446, -0.0016, _LARGE),
            _tube((0.0, 0.0, -0.0231), (0.41, 0.0, -0.0231), 0.034),
            housing(2, -0.0446, -0.0016, _LARGE, x=0.41),
        ),
    ),
    Link(
        "forearm",
        0.6763,
        (0.0, 0.081, 0.0028),
        (0.033, 0.2, 1),
        (
            housing(2, -0.0316, 0.0114, _LARGE),
            _tube((0.0, 0.0, -0.012), (0.0, 0.1976, 0.0), 0.034),
            housing(1, 0.1976, 0.2073, 0.034, colour=SILVER),
        ),
    ),
    Link(
        "wrist_1",
        0.463,
        (0.0, -0.0029, 0.0496),
        (_SMALL, 0.13, 2),
        (
            housing(2, 0.094, 0.1038, 0.034, colour=SILVER),
            housing(2, 0.024, 0.094, _SMALL, colour=BLACK),
            housing(1, -0.0475, 0.0, _SMALL),
        ),
    ),
    Link(
        "wrist_2",
        0.463,
        (0.0, 0.0497, -0.0029),
        (_SMALL, 0.13, 1),
        (
            housing(2, -0.0475, 0.0, _SMALL),
            housing(1, 0.024, 0.094, _SMALL, colour=BLACK),
            housing(1, 0.094, 0.1038, 0.034, colour=SILVER),
        ),
    ),
    Link(
        "hand",
        0.05,
        (0.0, 0.0, -0.03),
        (0.04, 0.06, 2),
        (
            housing(2, -0.02, 0.0, 0.034, colour=GREY),
            housing(2, -0.045, -0.02, 0.042, colour=GREY),
            housing(2, -HAND_BODY[1], -0.045, HAND_BODY[0], colour=GREY),
        ),
    ),
)
"""In the order of the joints. Most of the hand's mass is its palm's, which the gripper brings."""

_HINGES = tuple(
    Hinge(
        name=name,
        shift=jaco.SHIFT[index],
        twist=jaco.TWIST[index],
        along=jaco.ALONG[index],
        offset=jaco.OFFSET[index],
        limits=jaco.LIMITS[index],
        torque=jaco.TORQUE_LIMIT[index],
        stiffness=_STIFFNESS[index],
        armature=_ARMATURE[index],
    )
    for index, name in enumerate(jaco.JOINTS)
)

JACO = ArmBody(
    base=_BASE,
    hinges=_HINGES,
    links=_LINKS,
    touching=(("arm_base", "shoulder"),),
    speed=jaco.JOINT_SPEED,
    flipped=True,
    grip_force=25.0,
)
"""The arm; a finger's torque of 2 Nm presses with 25 N at the middle of its tip, 0.08 m on."""
