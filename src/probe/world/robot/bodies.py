"""Solids, masses and hinges put into an MjSpec. Knows no particular robot."""

from __future__ import annotations

from collections.abc import Sequence

import mujoco

from probe.types import Array, Vector3
from probe.world.robot.solids import Cylinder, SolidBox


def add_solids(body: mujoco.MjsBody, solids: Sequence[Cylinder | SolidBox]) -> None:
    """Add geoms that collide and are seen, named after the body and numbered from 0."""
    for number, solid in enumerate(solids):
        geom = body.add_geom(name=f"{body.name}_{number}", rgba=[*solid.colour, 1.0])
        if isinstance(solid, SolidBox):
            geom.type = mujoco.mjtGeom.mjGEOM_BOX
            geom.pos = solid.centre
            geom.size = solid.half_size
        else:
            kind = mujoco.mjtGeom
            geom.type = kind.mjGEOM_CAPSULE if solid.rounded else kind.mjGEOM_CYLINDER
            geom.fromto = [*solid.start, *solid.end]
            geom.size[0] = solid.radius


def set_inertia(body: mujoco.MjsBody, mass: float, centre: Vector3, inertia: Array) -> None:
    """Give a body its mass (kg), centre of mass (m) and principal inertia (kg m^2), shape (3,)."""
    body.explicitinertial = True
    body.mass = mass
    body.ipos = centre
    body.inertia = inertia


def add_hinge(
    body: mujoco.MjsBody,
    name: str,
    axis: Vector3,
    limits: tuple[float, float] | None,
    armature: float,
) -> mujoco.MjsJoint:
    """Add a hinge at the body's origin; limits in radians or none, armature in kg m^2."""
    joint = body.add_joint(name=name, axis=axis, armature=armature)
    joint.type = mujoco.mjtJoint.mjJNT_HINGE
    if limits is not None:
        joint.range = limits
    return joint
