"""Builds MuJoCo models of a table with objects; geometry and constants, no stepping."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import mujoco
import numpy as np
from scipy.spatial import ConvexHull

from probe.assets.mesh.mesh import Body, ConvexPiece
from probe.assets.spec import ObjectSpec
from probe.scene.setup import FLOOR_DEPTH, UR5_TABLE, Basket, Setup
from probe.types import Pose, Vector3
from probe.world.robot.robot import add_robot

TIME_STEP = 0.003
"""Seconds; contacts of 20 g objects stay stable up to here."""

GHOST_BIT = 4
"""Bit of the contact masks for what was taken away by magic: the basket alone is solid to it."""

WALL_HEIGHT = 0.6
_WALL_THICKNESS = 0.05
_TABLE_THICKNESS = 0.10
_BASKET_WALL = 0.01
_FRICTION_REST = (0.01, 1e-4)
"""Torsional and rolling coefficients (metres) of every contact."""

CONTACT_SOLREF = (0.01, 1.0)
"""Time constant (seconds) and damping ratio of every contact."""

_SPAWN_DAMPING = 1e-4
_SLEEP_TOLERANCE = 2e-3


@dataclass(frozen=True, eq=False)
class Item:
    """An object that a model is to contain."""

    instance: int
    spec: ObjectSpec
    body: Body

    @property
    def name(self) -> str:
        """Name of its body in the model."""
        return f"object/{self.instance}"


@dataclass(frozen=True)
class Post:
    """An upright cylinder that keeps a disc of the table free while a pile is dropped, metres."""

    x: float
    y: float
    radius: float


def new_spec(table_size: tuple[float, float]) -> mujoco.MjSpec:
    """An empty model with this project's solver options and the table."""
    spec = mujoco.MjSpec()
    option = spec.option
    option.timestep = TIME_STEP
    option.integrator = mujoco.mjtIntegrator.mjINT_IMPLICITFAST
    option.cone = mujoco.mjtCone.mjCONE_ELLIPTIC
    # Soft contacts creep on slopes; this ratio and stiffness keep that under 0.3 mm in 2 s.
    option.impratio = 100.0
    option.sleep_tolerance = _SLEEP_TOLERANCE
    option.enableflags |= mujoco.mjtEnableBit.mjENBL_SLEEP
    half = (table_size[0] / 2, table_size[1] / 2, _TABLE_THICKNESS / 2)
    _add_fixed_box(spec, "table", (0.0, 0.0, -_TABLE_THICKNESS / 2), half)
    return spec


def add_walls(spec: mujoco.MjSpec, work_area: float, posts: Sequence[Post] = ()) -> None:
    """Four walls around the work area, to keep a pile in while it is dropped, and posts."""
    reach, half_height = work_area / 2, WALL_HEIGHT / 2
    for name, x, y in (("e", 1, 0), ("w", -1, 0), ("n", 0, 1), ("s", 0, -1)):
        across = reach + _WALL_THICKNESS
        offset = reach + _WALL_THICKNESS / 2
        thin = _WALL_THICKNESS / 2
        spec.worldbody.add_geom(
            name=f"wall/{name}",
            type=mujoco.mjtGeom.mjGEOM_BOX,
            size=[thin if x else across, thin if y else across, half_height],
            pos=[x * offset, y * offset, half_height],
            friction=[0.05, *_FRICTION_REST],
            solref=CONTACT_SOLREF,
            condim=4,
        )
    for number, post in enumerate(posts):
        spec.worldbody.add_geom(
            name=f"wall/post/{number}",
            type=mujoco.mjtGeom.mjGEOM_CYLINDER,
            size=[post.radius, half_height, 0],
            pos=[post.x, post.y, half_height],
            friction=[0.05, *_FRICTION_REST],
            solref=CONTACT_SOLREF,
            condim=4,
        )


def add_item(spec: mujoco.MjSpec, item: Item) -> mujoco.MjsBody:
    """A free body with the item's convex pieces, its mass spread evenly over their volume."""
    body = spec.worldbody.add_body(name=item.name)
    joint = body.add_freejoint()
    joint.name = item.name
    joint.damping = [_SPAWN_DAMPING, 0.0, 0.0]
    density = item.spec.mass / sum(_volume(piece) for piece in item.body.pieces)
    for number, piece in enumerate(item.body.pieces):
        name = f"{item.spec.id}/{number}"
        if spec.mesh(name) is None:
            mesh = spec.add_mesh(name=name)
            mesh.uservert = piece.vertices.astype(np.float64).ravel()
            mesh.inertia = mujoco.mjtMeshInertia.mjMESH_INERTIA_CONVEX
        body.add_geom(
            type=mujoco.mjtGeom.mjGEOM_MESH,
            meshname=name,
            density=density,
            friction=[item.spec.friction, *_FRICTION_REST],
            solref=CONTACT_SOLREF,
            condim=4,
        )
    return body


def add_basket(spec: mujoco.MjSpec, basket: Basket) -> None:
    """The clearing basket: a floor and four walls on the table."""
    x, y, z = basket.position
    length, width, height = basket.size
    half = _BASKET_WALL / 2
    sides = [
        ("floor", (x, y, z + half), (length / 2, width / 2, half)),
        ("east", (x + length / 2 + half, y, z + height / 2), (half, width / 2, height / 2)),
        ("west", (x - length / 2 - half, y, z + height / 2), (half, width / 2, height / 2)),
        ("north", (x, y + width / 2 + half, z + height / 2), (length / 2, half, height / 2)),
        ("south", (x, y - width / 2 - half, z + height / 2), (length / 2, half, height / 2)),
    ]
    for name, centre, size in sides:
        _add_fixed_box(spec, f"basket/{name}", centre, size)
        spec.geom(f"basket/{name}").conaffinity = 1 | GHOST_BIT


def build_pile(
    items: Sequence[Item], posts: Sequence[Post] = (), setup: Setup = UR5_TABLE
) -> mujoco.MjModel:
    """A model for settling: table, walls, and the items, weightless until they are dropped."""
    spec = new_spec(setup.table_size)
    add_walls(spec, setup.work_area, posts)
    for item in items:
        add_item(spec, item)
        spec.body(item.name).gravcomp = 1.0
    return spec.compile()


def build_cell(
    items: Sequence[Item], poses: Mapping[int, Pose], setup: Setup = UR5_TABLE
) -> mujoco.MjModel:
    """A model for manipulation: table, floor, basket, robot, and the items at their poses."""
    spec = new_spec(setup.table_size)
    spec.worldbody.add_geom(
        name="floor",
        type=mujoco.mjtGeom.mjGEOM_PLANE,
        size=[3, 3, 0.1],
        pos=[0, 0, -FLOOR_DEPTH],
        friction=[0.7, *_FRICTION_REST],
        condim=4,
    )
    add_basket(spec, setup.basket)
    add_robot(spec, setup.mount, setup.gripper)
    for item in items:
        body = add_item(spec, item)
        body.pos, body.quat = poses[item.instance].position, poses[item.instance].wxyz
        # A settled object stays exactly where it is until something touches it.
        body.sleep = mujoco.mjtSleepPolicy.mjSLEEP_INIT
    return spec.compile()


def _add_fixed_box(spec: mujoco.MjSpec, name: str, centre: Vector3, half_size: Vector3) -> None:
    spec.worldbody.add_geom(
        name=name,
        type=mujoco.mjtGeom.mjGEOM_BOX,
        size=half_size,
        pos=centre,
        friction=[0.7, *_FRICTION_REST],
        solref=CONTACT_SOLREF,
        condim=4,
    )


def _volume(piece: ConvexPiece) -> float:
    return float(ConvexHull(piece.vertices).volume)
