"""The UR5 as bodies, joints and servos of an MjSpec. Knows no gripper and no table.

Masses and centres of mass: Universal Robots, "DH parameters for calculations of kinematics and
dynamics". Radii and lengths of the housings: measured on the maker's ROS description, enclosing it
to 6 mm but for the cable outlet at the base. Link frames are the DH frames
moved along their own joint axis, as in the maker's ROS description.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import mujoco

from probe.types import Array, Vector3
from probe.world.robot import ur5
from probe.world.robot.bodies import add_hinge, add_solids, set_inertia
from probe.world.robot.solids import BLUE, GREY, SILVER, Colour, Cylinder, cylinder_inertia

SERVO_LAG = 0.05
"""Seconds by which a servo trails a steadily moving command: damping over stiffness."""

STIFFNESS = (12000.0, 12000.0, 8000.0, 1500.0, 1500.0, 1500.0)
"""Servo stiffness, Nm/rad: what is held sags by 1 mm a kilogram."""

ARMATURE = (1.0, 1.0, 1.0, 0.2, 0.2, 0.2)
"""Inertia of motor and gears at the joint, kg m^2 (rotors of 1e-4 and 2e-5 behind gears of
101:1); it also keeps the servos stable at a time step of 3 ms."""


@dataclass(frozen=True)
class Link:
    """One link.

    Attributes:
        name: Of the body.
        mass: Kilograms.
        centre: Of mass, in the link's frame.
        barrel: Radius, length and axis of the cylinder that its inertia is taken from.
        solids: What collides and is seen.
    """

    name: str
    mass: float
    centre: Vector3
    barrel: tuple[float, float, int]
    solids: tuple[Cylinder, ...]


def _housing(
    axis: int, start: float, end: float, radius: float, *, x: float = 0.0, colour: Colour = GREY
) -> Cylinder:
    """A cylinder along axis 1 (y) or 2 (z) of the link, displaced along its x."""
    ends: list[Vector3] = [
        (x, place, 0.0) if axis == 1 else (x, 0.0, place) for place in (start, end)
    ]
    return Cylinder(ends[0], ends[1], radius, colour)


def _tube(z: float, length: float, radius: float) -> Cylinder:
    """The long part of an arm link, along -x."""
    return Cylinder((0.0, 0.0, z), (-length, 0.0, z), radius, SILVER, rounded=True)


BASE = (_housing(2, 0.0, 0.012, 0.0745), _housing(2, 0.012, 0.026, 0.0745, colour=SILVER))
"""The base flange, in the base frame."""

LINKS = (
    Link(
        "shoulder",
        3.7,
        (0.0, -0.00193, -0.02561),
        (0.06, 0.13, 2),
        (
            _housing(2, -0.065, 0.064, 0.06),
            _housing(2, 0.064, 0.0685, 0.057, colour=BLUE),
            _housing(1, -0.070, 0.0, 0.06),
        ),
    ),
    Link(
        "upper_arm",
        8.393,
        (-0.2125, 0.0, 0.11336),
        (0.06, 0.425, 0),
        (
            _tube(0.13585, 0.425, 0.058),
            _housing(2, 0.071, 0.196, 0.06),
            _housing(2, 0.196, 0.204, 0.055, colour=BLUE),
            _housing(2, 0.071, 0.196, 0.06, x=-0.425),
            _housing(2, 0.196, 0.204, 0.055, x=-0.425, colour=BLUE),
        ),
    ),
    Link(
        "forearm",
        2.33,
        (-0.24225, 0.0, 0.0265),
        (0.058, 0.39225, 0),
        (
            _tube(0.0165, 0.39225, 0.041),
            _housing(2, -0.025, 0.070, 0.058),
            _housing(2, -0.035, 0.063, 0.039, x=-0.39225),
            _housing(2, -0.041, -0.035, 0.036, x=-0.39225, colour=BLUE),
        ),
    ),
    Link(
        "wrist_1",
        1.219,
        (0.0, -0.01634, -0.0018),
        (0.045, 0.1, 2),
        (
            _housing(2, -0.045, 0.039, 0.039),
            _housing(1, -0.047, 0.051, 0.039),
            _housing(1, 0.051, 0.057, 0.036, colour=BLUE),
        ),
    ),
    Link(
        "wrist_2",
        1.219,
        (0.0, 0.01634, -0.0018),
        (0.045, 0.1, 2),
        (
            _housing(2, -0.045, 0.038, 0.039),
            _housing(1, -0.051, 0.047, 0.039),
            _housing(1, -0.057, -0.051, 0.036, colour=BLUE),
        ),
    ),
    Link(
        "wrist_3",
        0.1879,
        (0.0, 0.0, -0.001159),
        (0.0375, 0.0345, 2),
        (_housing(2, -0.034, 0.0, 0.0375, colour=SILVER),),
    ),
)
"""In the order of the joints; the frame of the last one is tool0."""

TOUCHING = (("arm_base", "shoulder"), ("wrist_1", "wrist_3"), ("forearm", "wrist_2"))
"""Links that no motion can press together although MuJoCo would see them touch."""


def add_arm(spec: mujoco.MjSpec, base: mujoco.MjsBody, posture: Sequence[float]) -> mujoco.MjsBody:
    """Add the arm with its servos; the specification's angles must be in radians.

    Args:
        spec: What to add to.
        base: The body whose frame is the arm's base frame; its name must be "arm_base".
        posture: Joint angles that the model is written down with, radians, shape (6,). The engine
            tries which objects can begin asleep while the arm is so: it should touch none.

    Returns:
        The last link, whose frame is tool0.
    """
    add_solids(base, BASE)
    body = base
    for index, link in enumerate(LINKS):
        body = _add_link(body, index, link, posture[index])
        _add_servo(spec, index)
    for first, second in TOUCHING:
        spec.add_exclude(bodyname1=first, bodyname2=second)
    return body


def _add_link(parent: mujoco.MjsBody, index: int, link: Link, angle: float) -> mujoco.MjsBody:
    x, twist = (ur5.A[index - 1], ur5.ALPHA[index - 1]) if index else (0.0, 0.0)
    c, s = math.cos(twist), math.sin(twist)
    body = parent.add_body(name=link.name, gravcomp=1.0)
    body.pos = [x, -s * ur5.D[index], c * ur5.D[index]]
    # The twist about x, then the joint's angle about z.
    (c, s), (k, n) = ((math.cos(a / 2), math.sin(a / 2)) for a in (twist, angle))
    body.quat = [c * k, s * k, -s * n, c * n]
    if index == 0:
        body.sleep = mujoco.mjtSleepPolicy.mjSLEEP_NEVER
    set_inertia(body, link.mass, link.centre, cylinder_inertia(link.mass, *link.barrel))
    limit = float(ur5.JOINT_LIMIT[index])
    add_hinge(body, ur5.JOINTS[index], (0.0, 0.0, 1.0), (-limit, limit), ARMATURE[index])
    body.joints[0].ref = angle
    add_solids(body, link.solids)
    return body


def _add_servo(spec: mujoco.MjSpec, index: int) -> None:
    name, torque = ur5.JOINTS[index], ur5.TORQUE_LIMIT[index]
    servo = spec.add_actuator(name=name, target=name, trntype=mujoco.mjtTrn.mjTRN_JOINT)
    servo.set_to_position(STIFFNESS[index], kv=STIFFNESS[index] * SERVO_LAG)
    limit = float(ur5.JOINT_LIMIT[index]) + ur5.JOINT_SPEED * SERVO_LAG
    servo.ctrlrange = [-limit, limit]
    servo.forcerange = [-torque, torque]


def servo_command(joints: Array, velocities: Array) -> Array:
    """Servo commands that make the arm follow a trajectory without trailing it.

    With them the tool errs by the joints' acceleration alone: start and end smoothly, as a motion
    of minimum jerk does, and the arm settles without overshoot.

    Args:
        joints: Where the arm should be at the start of this time step, radians, shape (6,).
        velocities: How fast it should be moving then, radians per second, shape (6,).
    """
    return joints + SERVO_LAG * velocities
