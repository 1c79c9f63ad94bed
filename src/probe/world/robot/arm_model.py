"""An arm as bodies, joints and servos of an MjSpec. Knows no gripper and no table."""

from __future__ import annotations

import math
from collections.abc import Sequence

import mujoco

from probe.types import Array
from probe.world.robot.arm_body import ArmBody, Hinge, Link
from probe.world.robot.bodies import add_hinge, add_solids, set_inertia
from probe.world.robot.solids import cylinder_inertia

SERVO_LAG = 0.05
"""Seconds by which a servo trails a steadily moving command: damping over stiffness."""


def add_arm(
    spec: mujoco.MjSpec, base: mujoco.MjsBody, arm: ArmBody, posture: Sequence[float]
) -> mujoco.MjsBody:
    """Add an arm with its servos; the specification's angles must be in radians.

    Args:
        spec: What to add to.
        base: The body whose frame is the arm's base frame; its name must be "arm_base".
        arm: What to add.
        posture: Joint angles that the model is written down with, radians, one a hinge. The engine
            tries which objects can begin asleep while the arm is so: it should touch none.

    Returns:
        The body whose frame is tool0.
    """
    add_solids(base, arm.base)
    body = base
    for hinge, link, angle in zip(arm.hinges, arm.links, posture, strict=True):
        body = _add_link(body, hinge, link, angle)
        if hinge is arm.hinges[0]:
            body.sleep = mujoco.mjtSleepPolicy.mjSLEEP_NEVER
        _add_servo(spec, hinge, arm.speed)
    for first, second in arm.touching:
        spec.add_exclude(bodyname1=first, bodyname2=second)
    return body.add_body(name="flange", quat=[0.0, 1.0, 0.0, 0.0]) if arm.flipped else body


def _add_link(parent: mujoco.MjsBody, hinge: Hinge, link: Link, angle: float) -> mujoco.MjsBody:
    c, s = math.cos(hinge.twist), math.sin(hinge.twist)
    body = parent.add_body(name=link.name, gravcomp=1.0)
    body.pos = [hinge.shift, -s * hinge.along, c * hinge.along]
    # The twist about x, then the joint's angle about z.
    turns = (hinge.twist, angle + hinge.offset)
    (c, s), (k, n) = ((math.cos(turn / 2), math.sin(turn / 2)) for turn in turns)
    body.quat = [c * k, s * k, -s * n, c * n]
    set_inertia(body, link.mass, link.centre, cylinder_inertia(link.mass, *link.barrel))
    add_hinge(body, hinge.name, (0.0, 0.0, 1.0), hinge.limits, hinge.armature)
    body.joints[0].ref = angle
    add_solids(body, link.solids)
    return body


def _add_servo(spec: mujoco.MjSpec, hinge: Hinge, speed: float) -> None:
    servo = spec.add_actuator(name=hinge.name, target=hinge.name, trntype=mujoco.mjtTrn.mjTRN_JOINT)
    servo.set_to_position(hinge.stiffness, kv=hinge.stiffness * SERVO_LAG)
    if hinge.limits is not None:
        smallest, largest = hinge.limits
        servo.ctrlrange = [smallest - speed * SERVO_LAG, largest + speed * SERVO_LAG]
    servo.forcerange = [-hinge.torque, hinge.torque]


def servo_command(joints: Array, velocities: Array) -> Array:
    """Servo commands that make the arm follow a trajectory without trailing it.

    With them the tool errs by the joints' acceleration alone: start and end smoothly, as a motion
    of minimum jerk does, and the arm settles without overshoot.

    Args:
        joints: Where the arm should be at the start of this time step, radians, shape (6,).
        velocities: How fast it should be moving then, radians per second, shape (6,).
    """
    return joints + SERVO_LAG * velocities
