"""Ports for servers that tests start."""

from __future__ import annotations

import socket
from contextlib import ExitStack, suppress


def free_ports(count: int = 1) -> int:
    """The first of some ports in a row at which nobody listens."""
    while True:
        with ExitStack() as held, suppress(OSError, OverflowError):
            first = held.enter_context(socket.socket())
            first.bind(("127.0.0.1", 0))
            port = first.getsockname()[1]
            for n in range(1, count):
                held.enter_context(socket.socket()).bind(("127.0.0.1", port + n))
            return port
