"""The Robotiq 2F-140 as bodies, joints and one drive of an MjSpec. Knows no arm."""

from __future__ import annotations

import math

import mujoco

from probe.scene.setup import GripperSize
from probe.world.robot.bodies import add_hinge, add_solids, set_inertia
from probe.world.robot.gripper import (
    FINGER_SPEED,
    INNER_PIVOT,
    JOINT_LIMIT,
    PIVOT,
    TILT,
    crank,
    tendon_force,
)
from probe.world.robot.gripper_shape import INNER_FINGER, PALM, inner_crank, outer_crank, pad
from probe.world.robot.solids import SolidBox, box_inertia, cylinder_inertia

DRIVE = "grip"
"""Name of the drive; its command is the joint angle wanted, 0 (open) to 0.7 (closed)."""

SIDES = ("left", "right")
"""The fingers: the left one on the -y side, as in the maker's description."""

STIFFNESS = 600.0
"""Of the drive, Nm/rad: it presses with full force from 2 mm before its command."""

ARMATURE = 0.01
"""Inertia of motor and gears felt at each outer crank, kg m^2."""

LIGHT = 1e-3
"""The same for the joints that only follow: keeps their ties stable, kg m^2."""

PALM_MASS, CRANK_MASS, INNER_MASS = 0.85, 0.031, 0.02
"""Kilograms; 1.0 in all, the maker's figure."""

PAD_FRICTION = (1.0, 0.01, 1e-4)
"""Rubber: sliding; torsion in metres, two thirds of a contact patch of 15 mm radius; rolling."""

STIFF = (0.005, 1.0)
"""Time constant in seconds and damping ratio; MuJoCo raises it to two time steps at least."""

TIE_IMPEDANCE = (0.99, 0.999, 0.001, 0.5, 2.0)
"""Keeps the pads parallel under the grip force."""

PAD_IMPEDANCE = (0.95, 0.99, 0.001, 0.5, 2.0)
"""Hard enough that 20 g sink in by 0.6 mm only; any harder, and the implicit integrators chatter.
The time constant sets how fast a held object creeps: 1 mm in a swing of a radian at 90 deg/s."""


def add_gripper(
    spec: mujoco.MjSpec, flange: mujoco.MjsBody, size: GripperSize, force: float
) -> None:
    """Add the gripper with its drive; the specification's angles must be in radians.

    Args:
        spec: What to add to.
        flange: The body whose frame is the gripper's frame.
        size: The gripper's.
        force: On each pad that the drive is limited to when nearly closed, newtons.
    """
    palm = flange.add_body(name="palm", gravcomp=1.0)
    set_inertia(palm, PALM_MASS, (0.0, 0.0, 0.035), cylinder_inertia(PALM_MASS, 0.0375, 0.09, 2))
    add_solids(palm, PALM)
    for side in SIDES:
        _add_finger(spec, palm, side, size, force)
    _tie(spec, "right_outer_crank", "left_outer_crank")
    _add_drive(spec, size, force)


def _add_finger(
    spec: mujoco.MjSpec, palm: mujoco.MjsBody, side: str, size: GripperSize, force: float
) -> None:
    length = crank(size)
    outer = _add_crank(palm, side, "outer_crank", PIVOT, outer_crank(size), length)
    outer.joints[0].armature = ARMATURE
    outer.joints[0].damping[0] = _drive_damping(size, force) / 2
    _add_crank(palm, side, "inner_crank", INNER_PIVOT, inner_crank(size), length)
    finger = outer.add_body(name=f"{side}_finger", gravcomp=1.0, pos=[0.0, 0.0, length])
    finger.quat = _about_x(-TILT)
    hull = INNER_FINGER[0]
    set_inertia(finger, INNER_MASS, hull.centre, box_inertia(INNER_MASS, hull.half_size))
    add_hinge(finger, f"{side}_finger", (1.0, 0.0, 0.0), (-0.1, 0.8), LIGHT)
    add_solids(finger, INNER_FINGER)
    _add_pad(finger, side, pad(size))
    for follower in ("inner_crank", "finger"):
        _tie(spec, f"{side}_{follower}", f"{side}_outer_crank")
    for other in ("outer_crank", "finger"):
        spec.add_exclude(bodyname1=f"{side}_inner_crank", bodyname2=f"{side}_{other}")


def _add_crank(
    palm: mujoco.MjsBody,
    side: str,
    name: str,
    pivot: tuple[float, float],
    solids: tuple[SolidBox, ...],
    length: float,
) -> mujoco.MjsBody:
    """A crank that turns from `TILT` outwards to upright; the right one is turned about z by pi."""
    sign = -1.0 if side == "left" else 1.0
    crank = palm.add_body(name=f"{side}_{name}", gravcomp=1.0, pos=[0.0, sign * pivot[0], pivot[1]])
    w, x, _, _ = _about_x(TILT)
    crank.quat = [w, x, 0.0, 0.0] if side == "left" else [0.0, 0.0, x, w]
    half = (0.012, 0.01, length / 2)
    set_inertia(crank, CRANK_MASS, (0.0, 0.0, length / 2), box_inertia(CRANK_MASS, half))
    add_hinge(crank, f"{side}_{name}", (-1.0, 0.0, 0.0), (-0.01, JOINT_LIMIT + 0.01), LIGHT)
    add_solids(crank, solids)
    return crank


def _add_pad(finger: mujoco.MjsBody, side: str, solid: SolidBox) -> None:
    geom = finger.add_geom(name=f"{side}_pad", rgba=[*solid.colour, 1.0])
    geom.type = mujoco.mjtGeom.mjGEOM_BOX
    geom.pos = solid.centre
    geom.size = solid.half_size
    geom.friction = PAD_FRICTION
    geom.condim = 4
    geom.priority = 1
    geom.solref = STIFF
    geom.solimp = PAD_IMPEDANCE


def _tie(spec: mujoco.MjSpec, follower: str, leader: str) -> None:
    """Make one joint turn as another does."""
    tie = spec.add_equality(name=follower, name1=follower, name2=leader)
    tie.type = mujoco.mjtEq.mjEQ_JOINT
    tie.objtype = mujoco.mjtObj.mjOBJ_JOINT
    tie.data[:5] = [0.0, 1.0, 0.0, 0.0, 0.0]
    tie.solref = STIFF
    tie.solimp = TIE_IMPEDANCE


def _add_drive(spec: mujoco.MjSpec, size: GripperSize, force: float) -> None:
    """One servo on the mean of both outer cranks, limited in force."""
    tendon = spec.add_tendon(name=DRIVE)
    for side in SIDES:
        tendon.wrap_joint(f"{side}_outer_crank", 0.5)
    drive = spec.add_actuator(name=DRIVE, target=DRIVE, trntype=mujoco.mjtTrn.mjTRN_TENDON)
    drive.set_to_position(STIFFNESS, kv=0.0)
    drive.ctrlrange = [0.0, JOINT_LIMIT]
    largest = tendon_force(force, size)
    drive.forcerange = [-largest, largest]


def _drive_damping(size: GripperSize, force: float) -> float:
    """Damping of the drive, Nm s/rad, at which its full force closes at `FINGER_SPEED`."""
    return tendon_force(force, size) / (FINGER_SPEED / crank(size))


def _about_x(angle: float) -> list[float]:
    return [math.cos(angle / 2), math.sin(angle / 2), 0.0, 0.0]
