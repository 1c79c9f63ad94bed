"""A Robotiq gripper through the socket that its URCap opens on a UR's controller.

The protocol is text: ``SET POS 255`` is answered by ``ack``, ``GET POS`` by ``POS 3``. Positions
are 0 (open) to 255 (closed); ``PRE`` echoes the goal that the gripper works on. Never tried on
hardware.
"""

from __future__ import annotations

import socket
import threading

PORT = 63352
_CLOSED = 255
_ACTIVE = 3
_MOVING = 0


class Robotiq:
    """An activated gripper.

    Args:
        host: The UR's controller.
        max_opening: Metres at position 0.

    Raises:
        OSError: Nobody listens there.
        RuntimeError: The gripper isn't active; activate it on the teach pendant.
    """

    def __init__(self, host: str, max_opening: float) -> None:
        self._max_opening = max_opening
        self._goal = 0
        self._lock = threading.Lock()
        self._socket = socket.create_connection((host, PORT), 2.0)
        if self._get("STA") != _ACTIVE:
            self._socket.close()
            raise RuntimeError("the gripper is not active; activate it on the teach pendant")

    def opening(self) -> float:
        """Metres."""
        return self._max_opening * (1.0 - self._get("POS") / _CLOSED)

    def start(self, opening: float) -> None:
        """Move towards an opening in metres."""
        position = round(_CLOSED * (1.0 - opening / self._max_opening))
        self._goal = position
        self._set("POS", position)
        self._set("GTO", 1)

    def resting(self) -> bool:
        """Whether it is there, or holds something; not before it has taken notice of its goal."""
        return self._get("PRE") == self._goal and self._get("OBJ") != _MOVING

    def stop(self) -> None:
        self._set("GTO", 0)

    def close(self) -> None:
        self._socket.close()

    def _get(self, name: str) -> int:
        words = self._ask(f"GET {name}").split()
        if len(words) != 2 or words[0] != name:
            raise RuntimeError(f"the gripper answers {' '.join(words)!r} to GET {name}")
        return int(words[1])

    def _set(self, name: str, value: int) -> None:
        reply = self._ask(f"SET {name} {value}")
        if reply != "ack":
            raise RuntimeError(f"the gripper answers {reply!r} to SET {name} {value}")

    def _ask(self, line: str) -> str:
        with self._lock:
            self._socket.sendall(line.encode("ascii") + b"\n")
            return self._socket.recv(1024).decode("ascii").strip()
