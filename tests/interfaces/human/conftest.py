"""A server over painted tables, in a thread."""

from __future__ import annotations

import socket
import threading
import time
from contextlib import contextmanager

import pytest
import uvicorn

from interfaces.human.painted_hall import Room, hall_in
from interfaces.human.visitor import Visitor
from probe.interfaces.human.app import app_of


@contextmanager
def serving(sessions):
    """The port of a server over a hall; both are closed in the end."""
    with socket.socket() as listening:
        listening.bind(("127.0.0.1", 0))
        listening.listen()
        config = uvicorn.Config(app_of(sessions), log_level="warning", ws="none", lifespan="off")
        server = uvicorn.Server(config)
        thread = threading.Thread(target=server.run, args=([listening],))
        thread.start()
        while not server.started:
            time.sleep(0.01)
        try:
            yield listening.getsockname()[1]
        finally:
            server.should_exit = True
            thread.join()
            sessions.close()


@pytest.fixture
def room():
    return Room()


@pytest.fixture
def visitor(tmp_path, room):
    with serving(hall_in(tmp_path, room)) as port:
        yield Visitor(port)
