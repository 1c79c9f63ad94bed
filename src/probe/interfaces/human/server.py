"""Runs the application on this machine alone; the only file that knows uvicorn."""

from __future__ import annotations

import socket
from collections.abc import Callable

import uvicorn

from probe.errors import ProbeError
from probe.interfaces.human.app import app_of
from probe.interfaces.human.session_manager import SessionManager

LOOPBACK = "127.0.0.1"

_PATIENCE = 5
"""Seconds for replies that are under way when it ends."""


class PortTaken(ProbeError):
    """Somebody else listens there."""

    def __init__(self, port: int, reason: str) -> None:
        super().__init__(f"Port {port} can't be used ({reason}). Choose another with --port.")


def run(sessions: SessionManager, port: int, ready: Callable[[str], None]) -> None:
    """Serve until interrupted.

    Args:
        sessions: Where people sit; it is left open.
        port: Where to listen; 0 for any that is free.
        ready: Is told the address as soon as it can be opened.

    Raises:
        PortTaken: The port can't be used.
        KeyboardInterrupt: Somebody pressed Ctrl-C.
    """
    with socket.socket() as listening:
        listening.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        try:
            listening.bind((LOOPBACK, port))
        except (OSError, OverflowError) as error:
            raise PortTaken(port, str(error)) from error
        listening.listen()
        ready(f"http://{LOOPBACK}:{listening.getsockname()[1]}/")
        config = uvicorn.Config(app_of(sessions), log_level="warning", ws="none", lifespan="off")
        config.timeout_graceful_shutdown = _PATIENCE
        uvicorn.Server(config).run(sockets=[listening])
