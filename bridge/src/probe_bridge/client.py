"""A robot somewhere else, as plain calls."""

from __future__ import annotations

import threading
from pathlib import Path
from typing import Any, Dict, List, NamedTuple, Optional, Sequence, Tuple

from probe_bridge.command_log import NOWHERE, CommandLog
from probe_bridge.description import (
    GlimpsePicture,
    Picture,
    read_description,
    read_glimpse,
    read_picture,
)
from probe_bridge.errors import BridgeError
from probe_bridge.fields import Fields
from probe_bridge.link import Link, Reply
from probe_bridge.renewing import Renewal
from probe_bridge.wire import VERSION

RENEW = 0.12
"""Seconds between two leases; the bridge stops the robot after 0.5 without one."""

ANSWER = 10.0
"""Seconds in which a bridge must answer all but motions; a motion's leases within 3."""

_LEASE_ANSWER = 3.0

GLIMPSE_ANSWER = 10.0
"""Seconds that a film's picture is waited for; nothing depends on it."""

FULL_SPEED = 1.0


class Motion(NamedTuple):
    """A motion under way; it goes on only while its lease is renewed.

    Attributes:
        reply: Comes when it has ended.
        renewal: Of its lease.
        stops: How often a stop had been asked for before.
    """

    reply: Reply
    renewal: Renewal
    stops: int

    def renew(self) -> None:
        """Let it go on for another while."""
        self.renewal.renew()
        self.renewal.look(0.0)


class RobotClient:
    """A robot behind a bridge. All calls block; `stop` may come from another thread.

    A motion's lease is renewed by the very thread that waits for the motion, so that the arm
    stops when the calling program hangs, and not only when its machine does.

    Args:
        address: ws://HOST:PORT, or wss://HOST:PORT with TLS.
        token: The bridge's token.
        certificate: Of the bridge, if no public authority vouches for it.
        log: File that gets a line for all that is commanded, and what came of it.

    Raises:
        BridgeError: "unauthorized", "version", "taken" or "lost". After "lost" nothing works any
            more; whoever knows that the robot is well makes a new client.
    """

    def __init__(
        self,
        address: str,
        token: str,
        certificate: Optional[Path] = None,
        log: Path = NOWHERE,
    ) -> None:
        self.log = CommandLog(log)
        self._link = Link(address, token, certificate, self.log)
        self._stops = 0
        self._held = False
        self._order = threading.Lock()
        try:
            self.description = read_description(self._ask("hello", version=VERSION))
        except BaseException:
            self._link.close()
            raise

    def close(self) -> None:
        """Leave; what moves stops."""
        self._link.close()

    @property
    def open(self) -> bool:
        """Whether the connection still stands, as far as is known."""
        return self._link.open

    def observe(self, camera: str, *, rgb: bool) -> Picture:
        """A picture of a camera that the description names."""
        return read_picture(self._ask("observe", camera=camera, rgb=rgb))

    def glimpse(self, camera: str, step: int) -> GlimpsePicture:
        """A small colour picture, for a film; from any thread, also during a motion.

        Args:
            camera: One that the description names.
            step: Of so many pixels of a row, and of so many rows, one is sent, 1 to 16.

        Raises:
            BridgeError: None came, or not in time; the connection stays open, as nothing that
                moves depends on it.
        """
        reply = self._link.send("glimpse", camera=camera, step=step)
        if not reply.came(GLIMPSE_ANSWER):
            raise BridgeError("late", f"No picture came for {GLIMPSE_ANSWER:.0f} s.")
        seen = self.description.cameras[camera]
        return read_glimpse(reply.result, seen, step, len(self.description.joints))

    def joints(self) -> Tuple[float, ...]:
        """Measured joint angles, radians."""
        return self._row(self._ask("joints"))

    def state(self) -> Dict[str, Any]:
        """Joints, their stamp, opening, whether it moves, lease left and the robot's clock."""
        return self._ask("state")

    def renewal(self) -> Renewal:
        """What renews the lease of whatever moves."""
        renewal = Renewal(self._link)
        renewal.first(ANSWER)
        return renewal

    def begin(self, path: Sequence[Sequence[float]], speed: float = FULL_SPEED) -> Motion:
        """Begin what follow does; the arm stops unless the caller renews the motion's lease."""
        rows: List[List[float]] = [[float(v) for v in row] for row in path]
        return self._begun("follow", path=rows, speed=float(speed))

    def follow(
        self, path: Sequence[Sequence[float]], speed: float = FULL_SPEED
    ) -> Tuple[float, ...]:
        """Move through joint angles, radians; the first row is where the arm is.

        Args:
            path: Waypoints.
            speed: Share of the robot's speed limits that the motion may use, 0.01 to 1.

        Returns:
            The measured angles at the end.

        Raises:
            BridgeError: "blocked" where something held the arm back; see errors.KINDS.
        """
        return self._row(self._ended(self.begin(path, speed)))

    def home(self, speed: float = FULL_SPEED) -> Tuple[float, ...]:
        """Move straight to the home position; speed, result and errors as of follow."""
        return self._row(self._ended(self._begun("home", speed=float(speed))))

    def grip(self, opening: float) -> float:
        """Move the hand towards an opening; return the one it reached, metres."""
        values = self._ended(self._begun("grip", opening=float(opening)))
        return Fields(values, "reply").number("opening")

    def wait(self, seconds: float) -> None:
        """Let things come to rest."""
        self._answered(self._link.send("wait", seconds=float(seconds)), seconds + ANSWER)

    def stop(self, *, hold: bool = False) -> None:
        """Stop arm and hand at once; a motion that runs raises "stopped".

        Its lease is renewed no more, so that it stops even if this request is lost.

        Args:
            hold: Send no further motion until `release`; they raise "stopped".
        """
        with self._order:
            self._stops += 1
            self._held = self._held or hold
            reply = self._link.send("stop")
        self._answered(reply, ANSWER)

    def release(self) -> None:
        """Let motions be sent again after a stop that holds."""
        self._held = False

    def _ask(self, do: str, **arguments: object) -> Dict[str, Any]:
        return self._answered(self._link.send(do, **arguments), ANSWER)

    def _answered(self, reply: Reply, seconds: float) -> Dict[str, Any]:
        if not reply.came(seconds):
            self._link.close()
            raise BridgeError("lost", f"The bridge did not answer for {seconds:.0f} s.")
        return reply.result

    def _begun(self, do: str, **arguments: object) -> Motion:
        """Ask for a motion.

        Raises:
            BridgeError: "stopped", or "lost"; then the connection is closed.
        """
        stops, renewal = self._stops, Renewal(self._link)
        try:
            renewal.first(ANSWER)
        except BridgeError:
            self._link.close()
            raise
        with self._order:
            if self._held or self._stops != stops:
                raise BridgeError("stopped", "It was stopped before it began.")
            reply = self._link.send(do, seen=renewal.seen, **arguments)
        return Motion(reply, renewal, stops)

    def _ended(self, motion: Motion) -> Dict[str, Any]:
        """Wait for a motion; stop it if this thread is interrupted."""
        try:
            while not motion.reply.came(RENEW):
                if self._stops == motion.stops:
                    motion.renewal.renew()
                if motion.renewal.look(RENEW) > _LEASE_ANSWER:
                    raise BridgeError("lost", "The bridge does not answer during a motion.")
        except BridgeError as error:
            if error.kind == "lost":
                self._link.close()
            raise
        except BaseException:
            self._link.send("stop")
            raise
        return motion.reply.result

    def _row(self, values: Dict[str, Any]) -> Tuple[float, ...]:
        return Fields(values, "reply").numbers("joints", len(self.description.joints))
