"""The UR5's body: its links, servos and limits. Knows no engine and no gripper.

Masses and centres of mass: Universal Robots, "DH parameters for calculations of kinematics and
dynamics". Radii and lengths of the housings: measured on the maker's ROS description, enclosing it
to 6 mm but for the cable outlet at the base. Link frames are the DH frames
moved along their own joint axis, as in the maker's ROS description.
"""

from __future__ import annotations

from probe.world.robot import ur5
from probe.world.robot.arm_body import ArmBody, Hinge, Link, housing
from probe.world.robot.solids import BLUE, SILVER, Cylinder

_STIFFNESS = (12000.0, 12000.0, 8000.0, 1500.0, 1500.0, 1500.0)
"""Servo stiffness, Nm/rad: what is held sags by 1 mm a kilogram."""

_ARMATURE = (1.0, 1.0, 1.0, 0.2, 0.2, 0.2)
"""Inertia of motor and gears at the joint, kg m^2 (rotors of 1e-4 and 2e-5 behind gears of
101:1); it also keeps the servos stable at a time step of 3 ms."""


def _tube(z: float, length: float, radius: float) -> Cylinder:
    """The long part of an arm link, along -x."""
    return Cylinder((0.0, 0.0, z), (-length, 0.0, z), radius, SILVER, rounded=True)


_BASE = (housing(2, 0.0, 0.012, 0.0745), housing(2, 0.012, 0.026, 0.0745, colour=SILVER))
"""The base flange, in the base frame."""

_LINKS = (
    Link(
        "shoulder",
        3.7,
        (0.0, -0.00193, -0.02561),
        (0.06, 0.13, 2),
        (
            housing(2, -0.065, 0.064, 0.06),
            housing(2, 0.064, 0.0685, 0.057, colour=BLUE),
            housing(1, -0.070, 0.0, 0.06),
        ),
    ),
    Link(
        "upper_arm",
        8.393,
        (-0.2125, 0.0, 0.11336),
        (0.06, 0.425, 0),
        (
            _tube(0.13585, 0.425, 0.058),
            housing(2, 0.071, 0.196, 0.06),
            housing(2, 0.196, 0.204, 0.055, colour=BLUE),
            housing(2, 0.071, 0.196, 0.06, x=-0.425),
            housing(2, 0.196, 0.204, 0.055, x=-0.425, colour=BLUE),
        ),
    ),
    Link(
        "forearm",
        2.33,
        (-0.24225, 0.0, 0.0265),
        (0.058, 0.39225, 0),
        (
            _tube(0.0165, 0.39225, 0.041),
            housing(2, -0.025, 0.070, 0.058),
            housing(2, -0.035, 0.063, 0.039, x=-0.39225),
            housing(2, -0.041, -0.035, 0.036, x=-0.39225, colour=BLUE),
        ),
    ),
    Link(
        "wrist_1",
        1.219,
        (0.0, -0.01634, -0.0018),
        (0.045, 0.1, 2),
        (
            housing(2, -0.045, 0.039, 0.039),
            housing(1, -0.047, 0.051, 0.039),
            housing(1, 0.051, 0.057, 0.036, colour=BLUE),
        ),
    ),
    Link(
        "wrist_2",
        1.219,
        (0.0, 0.01634, -0.0018),
        (0.045, 0.1, 2),
        (
            housing(2, -0.045, 0.038, 0.039),
            housing(1, -0.051, 0.047, 0.039),
            housing(1, -0.057, -0.051, 0.036, colour=BLUE),
        ),
    ),
    Link(
        "wrist_3",
        0.1879,
        (0.0, 0.0, -0.001159),
        (0.0375, 0.0345, 2),
        (housing(2, -0.034, 0.0, 0.0375, colour=SILVER),),
    ),
)
"""In the order of the joints; the frame of the last one is tool0."""

_HINGES = tuple(
    Hinge(
        name=name,
        shift=ur5.A[index - 1] if index else 0.0,
        twist=ur5.ALPHA[index - 1] if index else 0.0,
        along=ur5.D[index],
        offset=0.0,
        limits=(-float(ur5.JOINT_LIMIT[index]), float(ur5.JOINT_LIMIT[index])),
        torque=ur5.TORQUE_LIMIT[index],
        stiffness=_STIFFNESS[index],
        armature=_ARMATURE[index],
    )
    for index, name in enumerate(ur5.JOINTS)
)

UR5 = ArmBody(
    base=_BASE,
    hinges=_HINGES,
    links=_LINKS,
    touching=(("arm_base", "shoulder"), ("wrist_1", "wrist_3"), ("forearm", "wrist_2")),
    speed=ur5.JOINT_SPEED,
    flipped=False,
    grip_force=60.0,
)
"""The arm; its hand is the 2F-140, limited to half of the force that it can have."""
