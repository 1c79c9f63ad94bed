"""Grasps from a GraspGen server (Murali et al., "GraspGen", 2025) instead of our own planner.

Only the server's protocol is used: ZMQ request and reply, msgpack with numpy arrays. It knows the
object's points alone, so what stands around is checked here. Its hand: z is the approach, it
closes along x, the origin is the gripper's base.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, cast

import numpy as np

from probe.errors import MissingExtra, ProbeError
from probe.manipulation.candidates import Grasp, grasp_of
from probe.manipulation.clearance import MARGINS, Clearance
from probe.manipulation.closing import close
from probe.manipulation.handshape import HandShape
from probe.manipulation.pairs import MAX_TILT, HandPoses
from probe.manipulation.target import Target
from probe.manipulation.terrain import Terrain
from probe.station.station import Hand
from probe.types import Array

DEPTH = 0.195
"""Metres from the base of GraspGen's robotiq_2f_140 to between its pads; another gripper on the
server needs its own."""

_POINTS = 2000
_FEWEST = 50


class GraspServerFailed(ProbeError):
    """A GraspGen server gave no usable answer."""

    def __init__(self, address: str, reason: str) -> None:
        super().__init__(
            f"The GraspGen server at {address} {reason}. Start it with the gripper "
            "robotiq_2f_140, check the address, or leave the planner out to use the built-in one."
        )


@dataclass(frozen=True)
class GraspGen:
    """A Planner that asks a server.

    Attributes:
        address: As ZMQ has it ("tcp://localhost:5556").
        timeout: Seconds to wait for an answer.
        count: Grasps to ask for.
        depth: Metres from the gripper's base to between its pads.
    """

    address: str
    timeout: float = 30.0
    count: int = 200
    depth: float = DEPTH

    def __call__(self, target: Target, terrain: Terrain, hand: Hand) -> list[Grasp]:
        """Grasps of a target that fit between what stands around, most trusted first.

        Raises:
            GraspServerFailed: No answer in time, an error, or one that makes no sense.
            MissingExtra: The packages for the protocol aren't installed.
        """
        if len(target.top) < _FEWEST:
            return []
        points = target.top[:: max(1, len(target.top) // _POINTS)]
        poses, trust = self._asked(points)
        if len(poses) == 0:
            return []
        shape = HandShape(hand)
        hands, trust = self._ours(poses, trust, target, hand)
        for margin in MARGINS[1:3]:
            room = Clearance.of(shape, margin, terrain, target)
            free = np.flatnonzero(room.way_free(hands))
            if len(free):
                return [grasp_of(room, hands, int(k), float(trust[k])) for k in free]
        return []

    def _ours(
        self, poses: Array, trust: Array, target: Target, hand: Hand
    ) -> tuple[HandPoses, Array]:
        """The server's hands as ours, closed on what is seen; those that hold nothing left out."""
        x, y, z = poses[:, :3, 0], poses[:, :3, 1], poses[:, :3, 2]
        rotations = np.stack([-y, x, z], axis=2)
        centres = poses[:, :3, 3] + self.depth * z
        tilts = np.arccos(np.clip(-z[:, 2], -1.0, 1.0))
        hands = HandPoses(rotations, centres, np.full(len(poses), hand.max_opening), tilts)
        hands, merits = close(hands, target, hand.pad_half, hand.max_opening / 2)
        good = np.isfinite(merits) & (tilts <= MAX_TILT) & (hands.widths < hand.max_opening)
        return hands[good], trust[good]

    def _asked(self, points: Array) -> tuple[Array, Array]:
        """Poses, shape (n, 4, 4), of the server's hand in the world, and how far it trusts them."""
        answer = self._exchange(
            {
                "action": "infer",
                "point_cloud": points.astype(np.float32),
                "num_grasps": self.count,
                "grasp_threshold": -1.0,
                "topk_num_grasps": -1,
            }
        )
        if "error" in answer:
            raise GraspServerFailed(self.address, f"says: {str(answer['error'])[:300]}")
        try:
            poses = np.asarray(answer["grasps"], float).reshape(-1, 4, 4)
            trust = np.asarray(answer["confidences"], float).reshape(len(poses))
        except (KeyError, TypeError, ValueError) as error:
            raise GraspServerFailed(self.address, f"sent no grasps ({error!r})") from error
        turns = poses[:, :3, :3]
        straight = np.abs(turns @ turns.transpose(0, 2, 1) - np.eye(3)).max(initial=0.0) < 1e-2
        if not (np.isfinite(poses).all() and np.isfinite(trust).all() and straight):
            raise GraspServerFailed(self.address, "sent poses that are no rigid motions")
        order = np.argsort(-trust, kind="stable")
        return poses[order], trust[order]

    def _exchange(self, request: Mapping[str, object]) -> Mapping[str, Any]:
        """One question and its answer. A socket that waited in vain is of no use afterwards."""
        try:
            import msgpack
            import msgpack_numpy
            import zmq
        except ImportError as error:
            raise MissingExtra("Asking a GraspGen server", "graspgen") from error
        wire = cast(Any, zmq)  # half of its types are unknown
        try:
            with wire.Context.instance().socket(wire.REQ) as socket:
                socket.setsockopt(wire.LINGER, 0)
                socket.connect(self.address)
                socket.send(msgpack.packb(request, default=msgpack_numpy.encode))
                if not socket.poll(round(1000 * self.timeout)):
                    raise GraspServerFailed(self.address, f"gave no answer in {self.timeout:g} s")
                reply = socket.recv()
            return _mapping(msgpack.unpackb(reply, object_hook=msgpack_numpy.decode))
        except (zmq.ZMQError, ValueError, msgpack.UnpackException) as error:
            raise GraspServerFailed(self.address, f"can't be understood ({error})") from error


def _mapping(answer: object) -> Mapping[str, Any]:
    if not isinstance(answer, dict):
        raise ValueError("no answer but something else")
    return cast(dict[str, Any], answer)
