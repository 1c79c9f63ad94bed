"""A robot behind a bridge as a Station: skills and tools work on it as on the simulated one."""

from __future__ import annotations

from collections.abc import Generator
from contextlib import AbstractContextManager, contextmanager, nullcontext
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from probe.errors import ArmInView, BadData, MissingExtra, RobotLost
from probe.scene.cameras import View
from probe.scene.setup import Setup
from probe.station.arms import arm_of, hand_of
from probe.station.fusing import FRAMES, fused
from probe.station.motion_camera import Keep, MotionCamera
from probe.station.station import Arm, Hand
from probe.station.straightened import Straightened
from probe.types import Array, Frame

if TYPE_CHECKING:
    from probe_bridge.client import RobotClient
    from probe_bridge.description import Description

BASKET_VIEW = "basket"
"""Name of the camera that looks into the basket; the others are called as a set-up's views."""

PARKED = 0.06
"""Radians by which a joint may be off where the arm was sent, as in simulation: motors give way a
little. One value for arriving and for being parked, or an arm could arrive at home and still be in
view."""

STALE = 0.25
"""Seconds by which a picture may be older than the call that asked for it. An older one may show
the table as it was before the last motion."""

_ANGLES = 1e-6


SLOW = 0.25
"""Share of a robot's speed limits that its slow motions use."""


def connected(
    address: str, token: str, certificate: Path | None = None, log: Path | None = None
) -> RobotClient:
    """A connection to a robot's bridge; close it when done.

    Args:
        address: "ws://HOST:PORT", or "wss://HOST:PORT" with TLS.
        token: The bridge's.
        certificate: Of the bridge, if no public authority vouches for it.
        log: File that all commands are appended to, and what came of them.

    Raises:
        MissingExtra: probe-bridge isn't installed.
        RobotLost: Nobody answers, the token is wrong, or the versions differ.
    """
    try:
        from probe_bridge.client import RobotClient
        from probe_bridge.command_log import NOWHERE
    except ImportError as error:
        raise MissingExtra("A robot", "robot", "./bridge") from error
    with _bridge_errors():
        return RobotClient(address, token, certificate, log or NOWHERE)


class RobotStation:
    """A Station over a bridge. Nothing here knows what stands on the table.

    Args:
        client: Connected to the robot's bridge; whoever made it closes it.
        setup: The table as it was measured: arm, hand, basket, areas. What its cameras see is
            taken from the bridge, not from here.
        view: Which camera shows the table.
        looks: Pictures that are fused into one; depth cameras flicker.
        slow: How many of the arm's first motions use no more than SLOW of its speed limits; the
            bridge sees to it. The hand's speed is its driver's affair.

    Raises:
        BadData: The bridge's robot has other joints, or lacks a camera that is needed.
    """

    def __init__(
        self,
        client: RobotClient,
        setup: Setup,
        view: View = "front",
        looks: int = FRAMES,
        slow: int = 0,
    ) -> None:
        self.arm: Arm = arm_of(setup.mount)
        self.hand: Hand = hand_of(setup)
        _check(client.description, self.arm, setup, view)
        self._client = client
        self._setup = setup
        self._view: View = view
        self._looks = looks
        self._slow = slow
        self._maps: dict[str, Straightened] = {}
        self._film: MotionCamera | None = None

    def film(self, keep: Keep) -> None:
        """From now on, keep pictures of the table while the robot moves.

        Args:
            keep: Gets them, in a thread of their own.
        """
        self._film = MotionCamera(self._client, self._view, keep)

    def observe(self, *, rgb: bool) -> Frame:
        """Look at the table with the fixed camera.

        Raises:
            ArmInView: The arm isn't parked, so it would hide part of the table.
            RobotLost: The bridge doesn't answer, or its pictures are old.
        """
        return self._seen_by(self._view, self._setup.picture_px, rgb=rgb)

    def look_into_basket(self, *, rgb: bool) -> Frame:
        """Look into the basket with the camera above it; raises as observe does."""
        return self._seen_by(BASKET_VIEW, self._setup.basket_camera.width_px, rgb=rgb)

    def joints(self) -> Array:
        """Joint angles as measured, radians, shape (n,)."""
        with _bridge_errors():
            return np.array(self._client.joints())

    def follow(self, path: Array) -> bool:
        """Move through joint angles, shape (m, n), in one motion, and come to rest.

        Returns:
            Whether the arm got there, all joints within PARKED. The bridge stops it where it is as
            soon as something holds it back.

        Raises:
            RobotLost: The motion ended otherwise: refused, stopped by a person, the link cut.
        """
        with _bridge_errors(), self._filming():
            start = self._client.joints()
            return self._moved(np.vstack([start, path]))

    def grip(self, opening: float) -> float:
        """Open or close the gripper towards an opening in metres, and say what it reached."""
        with _bridge_errors(), self._filming():
            return self._client.grip(min(opening, self._client.description.max_opening))

    def park(self) -> None:
        """Move straight to where the arm hides nothing, whatever is in its way.

        Raises:
            RobotLost: It was stopped, or didn't get there.
        """
        with _bridge_errors(), self._filming():
            self._client.home()

    def wait(self, seconds: float) -> None:
        """Let things come to rest for so many seconds."""
        with _bridge_errors():
            self._client.wait(seconds)

    def stop(self) -> None:
        """Stop arm and hand now, from any thread, also while another waits for a motion.

        Nothing moves any more until `release`.

        Raises:
            RobotLost: The bridge didn't confirm it. The connection is closed then, by which the
                arm stops, too.
        """
        with _bridge_errors():
            try:
                self._client.stop(hold=True)
            except BaseException:
                self._client.close()
                raise

    def release(self) -> None:
        """Let motions begin again after a stop."""
        self._client.release()

    def glance(self) -> Frame:
        """What the camera sees now, the arm included; from any thread."""
        with _bridge_errors():
            picture = self._client.observe(self._view, rgb=True)
        straight = Straightened.of(picture.camera, self._setup.picture_px)
        return Frame(straight.camera, straight.depth(picture), straight.rgb(picture))

    def note(self, event: str, **about: object) -> None:
        """Add a line to the client's log of commands."""
        with _bridge_errors():
            self._client.log.add(event, **about)

    def _filming(self) -> AbstractContextManager[None]:
        return nullcontext() if self._film is None else self._film.filming()

    def _moved(self, path: Array) -> bool:
        from probe_bridge.errors import BridgeError

        try:
            self._slow -= 1
            rest = self._client.follow(path.tolist(), SLOW if self._slow >= 0 else 1.0)
        except BridgeError as error:
            if error.kind == "blocked":
                return False
            raise
        return bool(np.abs(rest - path[-1]).max() < PARKED)

    def _seen_by(self, camera: str, size_px: int, *, rgb: bool) -> Frame:
        if np.abs(self.joints() - self.arm.parked).max() > PARKED:
            raise ArmInView
        with _bridge_errors():
            asked = float(self._client.state()["clock"])
            pictures = [
                self._client.observe(camera, rgb=rgb and k == 0) for k in range(self._looks)
            ]
        late = asked - min(picture.stamp for picture in pictures)
        if late > STALE:
            raise RobotLost(
                f"Camera {camera} gave a picture that was {late:.1f} s old when it was asked for. "
                "Look whether the camera still runs."
            )
        if camera not in self._maps:
            self._maps[camera] = Straightened.of(pictures[0].camera, size_px)
        straight = self._maps[camera]
        told = fused([straight.depth(picture) for picture in pictures])
        colours = straight.rgb(pictures[0]) if rgb else None
        return Frame(
            straight.camera,
            told.depth,
            colours,
            depth_noise=told.noise,
            measured=told.measured,
        )


def _check(told: Description, arm: Arm, setup: Setup, view: View) -> None:
    """Refuse a robot that isn't the set-up's."""
    path = f"robot {told.name!r}"
    if len(told.joints) != len(arm.parked):
        raise BadData(
            path,
            f"it has {len(told.joints)} joints, the set-up's {setup.mount.arm} {len(arm.parked)}",
            "Name the right set-up",
        )
    if np.abs(np.array(told.home) - arm.parked).max() > _ANGLES:
        raise BadData(
            path,
            f"its home {told.home} isn't where the set-up parks the arm, {setup.mount.parked}",
            "Write the same angles into both files",
        )
    for camera in (view, BASKET_VIEW):
        if camera not in told.cameras:
            known = ", ".join(told.cameras) or "none"
            raise BadData(
                path, f"it has no camera called {camera!r}, but {known}", "Add it to its file"
            )


@contextmanager
def _bridge_errors() -> Generator[None]:
    """What goes wrong beyond the bridge ends an episode; it is nobody's wrong answer."""
    from probe_bridge.errors import BridgeError

    try:
        yield
    except BridgeError as error:
        raise RobotLost(f"{error} ({error.kind})") from error
