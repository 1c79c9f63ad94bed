"""Drops objects one by one into a pile and lets them come to rest."""

from __future__ import annotations

from collections.abc import Sequence

import mujoco
import numpy as np

from probe.scene.sampling import Drop
from probe.scene.setup import UR5_TABLE, Setup
from probe.types import Array, Pose
from probe.world.model import TIME_STEP, Item, Post, build_pile

DROP_CLEARANCE = 0.01
"""Metres between a dropped object and the highest thing beneath it."""

SINK_LIMIT = 0.003
"""Metres that a resting object may sink into the table or into another one."""

_HELD_DAMPING = 1e5
_PARKED_Z = -3.0
_PARKED_SPACING = 1.0
_CHUNK = 25
_WALL = 2
"""Bit of the contact masks that walls and posts have for their own."""

_WALLS = ("wall/e", "wall/w", "wall/n", "wall/s")


class Pile:
    """A table with walls onto which items are dropped; weightless and far away until then."""

    def __init__(
        self, items: Sequence[Item], posts: Sequence[Post] = (), setup: Setup = UR5_TABLE
    ) -> None:
        self.items = tuple(items)
        self._setup = setup
        self.model = build_pile(items, posts, setup)
        self._walls = [*_WALLS, *(f"wall/post/{number}" for number in range(len(posts)))]
        self.data = mujoco.MjData(self.model)
        self._body = {i.instance: self.model.body(i.name).id for i in items}
        self._corners = {
            i.instance: np.concatenate([piece.vertices for piece in i.body.pieces]) for i in items
        }
        self._free_damping: Array = self.model.dof_damping.copy()
        self._dropped: set[int] = set()
        self.hold()
        self.set_walls(standing=True)
        for item in items:
            self.park(item.instance)
        mujoco.mj_forward(self.model, self.data)

    def pose(self, instance: int) -> Pose:
        """world_from_object of an item."""
        at = self._qpos(instance)
        return Pose.of(self.data.qpos[at : at + 3], self.data.qpos[at + 3 : at + 7])

    def bounds(self, instance: int) -> Array:
        """Lowest and highest corner of an item's collision shape, shape (2, 3)."""
        corners = self.corners(instance)
        return np.stack([corners.min(axis=0), corners.max(axis=0)])

    def corners(self, instance: int) -> Array:
        """Corners of an item's collision shape where it is, shape (n, 3)."""
        return self.pose(instance).apply(self._corners[instance])

    @property
    def on_table(self) -> tuple[int, ...]:
        """Instances that have been dropped or placed and not taken away since."""
        return tuple(sorted(self._dropped))

    def place(self, instance: int, pose: Pose) -> None:
        """Put an item exactly here (world_from_object), at rest but subject to gravity."""
        self._dropped.add(instance)
        self.model.body_gravcomp[self._body[instance]] = 0.0
        self._put(instance, pose, speed=-1e-6)

    def hold(self, *instances: int) -> None:
        """Keep items from moving, however hard others lean on them; all others go free.

        Walls and posts pass through what is held, or they would push it out of their way.
        """
        self.model.dof_damping[:] = self._free_damping
        for item in self.items:
            held = item.instance in instances
            body = self._body[item.instance]
            self.model.geom_conaffinity[self.model.geom_bodyid == body] = 1 if held else 1 | _WALL
            if held:
                at = self._dof(item.instance)
                self.model.dof_damping[at : at + 6] = _HELD_DAMPING

    def park(self, instance: int) -> None:
        """Take an item off the table."""
        self._dropped.discard(instance)
        self.model.body_gravcomp[self._body[instance]] = 1.0
        self._put(instance, Pose((_PARKED_SPACING * instance, 0.0, _PARKED_Z)), speed=0.0)

    def drop(self, instance: int, drop: Drop) -> None:
        """Let an item fall from just above whatever lies beneath its spot."""
        turned = Pose((0.0, 0.0, 0.0), drop.wxyz).apply(self._corners[instance])
        low, high = turned.min(axis=0), turned.max(axis=0)
        middle = np.array([drop.x, drop.y]) - (low + high)[:2] / 2
        beneath = self._top_under(low[:2] + middle, high[:2] + middle)
        z = beneath + DROP_CLEARANCE - float(low[2])
        self._dropped.add(instance)
        self.model.body_gravcomp[self._body[instance]] = 0.0
        # A sleeping body only notices that it may fall when it moves.
        self._put(instance, Pose((float(middle[0]), float(middle[1]), z), drop.wxyz), speed=-0.05)

    def fall(self, at_most: float, slow: float = 0.0) -> None:
        """Step until everything sleeps or is slow, at most so many seconds.

        Args:
            at_most: Seconds.
            slow: Metres a second under which nothing needs to come to rest any further.
        """
        for _ in range(round(at_most / TIME_STEP / _CHUNK)):
            mujoco.mj_step(self.model, self.data, _CHUNK)
            if self.asleep or self._speed() < slow:
                return

    @property
    def asleep(self) -> bool:
        """Whether the engine has put every body to sleep."""
        return bool((self.data.tree_asleep >= 0).all())

    def set_walls(self, *, standing: bool) -> None:
        """Put walls and posts up, or take them away so that objects lean and roll as they will."""
        for name in self._walls:
            geom = self.model.geom(name).id
            self.model.geom_contype[geom] = _WALL if standing else 0
            self.model.geom_conaffinity[geom] = 0
        self.wake()

    def wake(self) -> None:
        """Make every dropped body take part in the next step."""
        for instance in sorted(self._dropped):
            at = self._dof(instance)
            self.data.qvel[at + 2] -= 1e-6

    def freeze(self) -> None:
        """Forget all speeds and what the solver remembers, as if rebuilt from the poses."""
        self.data.qvel[:] = 0.0
        self.data.qacc_warmstart[:] = 0.0

    def stay_awake(self, *, awake: bool) -> None:
        """Switch the engine's sleeping off or on again."""
        bit = int(mujoco.mjtEnableBit.mjENBL_SLEEP)
        flags = self.model.opt.enableflags
        self.model.opt.enableflags = flags & ~bit if awake else flags | bit

    def step(self, seconds: float) -> None:
        """Step so many seconds."""
        mujoco.mj_step(self.model, self.data, round(seconds / TIME_STEP))

    def penetration(self) -> float:
        """Deepest overlap of two collision shapes in metres, in the last step taken awake."""
        return max(0.0, -float(self.data.contact.dist.min(initial=0.0)))

    def is_inside(self, instance: int) -> bool:
        """Whether an item rests on the table, all of it within the camera's view of the table."""
        low, high = self.bounds(instance)
        reach = self._setup.view_size / 2
        within = (low[:2] >= -reach).all() and (high[:2] <= reach).all()
        return bool(within and low[2] > -SINK_LIMIT)

    def _speed(self) -> float:
        """Fastest linear speed of any item along any axis, metres a second."""
        return float(np.abs(self.data.qvel.reshape(-1, 6)[:, :3]).max())

    def _top_under(self, low: Array, high: Array) -> float:
        """Highest point of dropped items whose bounds overlap a rectangle of the table."""
        top = 0.0
        for instance in self._dropped:
            bounds = self.bounds(instance)
            if (bounds[0, :2] < high).all() and (bounds[1, :2] > low).all():
                top = max(top, float(bounds[1, 2]))
        return top

    def _put(self, instance: int, pose: Pose, speed: float) -> None:
        at, dof = self._qpos(instance), self._dof(instance)
        self.data.qpos[at : at + 7] = (*pose.position, *pose.wxyz)
        self.data.qvel[dof : dof + 6] = (0.0, 0.0, speed, 0.0, 0.0, 0.0)
        self.data.qacc_warmstart[dof : dof + 6] = 0.0

    def _qpos(self, instance: int) -> int:
        return int(self.model.jnt_qposadr[self.model.body_jntadr[self._body[instance]]])

    def _dof(self, instance: int) -> int:
        return int(self.model.jnt_dofadr[self.model.body_jntadr[self._body[instance]]])
