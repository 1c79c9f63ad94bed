"""Runs the application on this machine alone; the only file that knows uvicorn."""

from __future__ import annotations

import socket
import threading
from collections.abc import Callable, Generator
from contextlib import contextmanager

import uvicorn
from starlette.applications import Starlette

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


@contextmanager
def listening(port: int) -> Generator[socket.socket]:
    """A socket that listens on this machine alone.

    Args:
        port: Where; 0 for any that is free.

    Raises:
        PortTaken: The port can't be used.
    """
    with socket.socket() as opened:
        opened.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        try:
            opened.bind((LOOPBACK, port))
        except (OSError, OverflowError) as error:
            raise PortTaken(port, str(error)) from error
        opened.listen()
        yield opened


@contextmanager
def served(app: Starlette, port: int) -> Generator[str]:
    """Serve an application in a thread, as long as the block lasts; gives its address.

    Args:
        app: What is served.
        port: Where to listen; 0 for any that is free.

    Raises:
        PortTaken: The port can't be used.
    """
    with listening(port) as opened:
        config = uvicorn.Config(app, log_level="warning", ws="none", lifespan="off")
        config.timeout_graceful_shutdown = 1
        server = uvicorn.Server(config)
        thread = threading.Thread(target=server.run, args=([opened],), name="page")
        thread.start()
        try:
            yield f"http://{LOOPBACK}:{opened.getsockname()[1]}/"
        finally:
            server.should_exit = True
            thread.join()


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
    with listening(port) as opened:
        ready(f"http://{LOOPBACK}:{opened.getsockname()[1]}/")
        config = uvicorn.Config(app_of(sessions), log_level="warning", ws="none", lifespan="off")
        config.timeout_graceful_shutdown = _PATIENCE
        uvicorn.Server(config).run(sockets=[opened])
