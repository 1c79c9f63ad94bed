"""A client's side of the lease: renewals out, and what their answers tell."""

from __future__ import annotations

from typing import List

from probe_bridge.errors import BridgeError
from probe_bridge.fields import Fields
from probe_bridge.link import Link, Reply


class Renewal:
    """Renews the lease of one motion.

    Args:
        link: To the bridge.

    Attributes:
        seen: The robot's clock as the newest answer told it, seconds. What is sent to the robot
            carries it, so that the bridge can tell how old the client's knowledge is.
    """

    def __init__(self, link: Link) -> None:
        self.seen = 0.0
        self._link = link
        self._sent: List[Reply] = []
        self._unsure = 0.0

    def first(self, seconds: float) -> None:
        """Ask for the robot's clock; nothing moves by that.

        Raises:
            BridgeError: "lost"; no answer came in so many seconds.
        """
        reply = self._link.send("lease", seen=self.seen)
        if not reply.came(seconds):
            raise BridgeError("lost", f"The bridge did not answer for {seconds:.0f} s.")
        self._read(reply)

    def renew(self) -> None:
        """Send a renewal; doesn't wait for its answer."""
        self._sent.append(self._link.send("lease", seen=self.seen))

    def look(self, passed: float) -> float:
        """Read the answers that have come; any of them will do, as others may be lost.

        Args:
            passed: Seconds since the last look.

        Returns:
            For how many seconds no answer has said that something moves.
        """
        came = [reply for reply in self._sent if reply.came()]
        self._sent = [reply for reply in self._sent if reply not in came]
        moves = [self._read(reply) for reply in came]
        self._unsure = 0.0 if any(moves) else self._unsure + passed
        return self._unsure

    def _read(self, reply: Reply) -> bool:
        fields = Fields(reply.result, "reply")
        self.seen = max(self.seen, fields.number("clock", 0.0, 1e12))
        return fields.flag("moving")
