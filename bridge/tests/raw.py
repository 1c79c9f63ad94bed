"""A client that sends whatever a test wants, right or wrong."""

from __future__ import annotations

import time
from contextlib import contextmanager
from typing import Any, Dict, Generator, Optional

from websockets.sync.client import ClientConnection, connect

from bridges import TOKEN
from probe_bridge.wire import VERSION, pack, unpack_reply

HELLO = {"seq": 1, "do": "hello", "version": VERSION}


@contextmanager
def connected(
    address: str, token: Optional[str] = TOKEN
) -> Generator[ClientConnection, None, None]:
    """An open websocket; with no token, no header is sent."""
    headers = {} if token is None else {"Authorization": f"Bearer {token}"}
    with connect(address, additional_headers=headers, compression=None) as socket:
        yield socket


def now() -> Dict[str, float]:
    """What a request to move carries: the robot's clock, which on this machine is ours."""
    return {"seen": time.monotonic()}


def ask(socket: ClientConnection, message: Dict[str, Any]) -> Dict[str, Any]:
    """Send a message and return the next reply, whatever it is for."""
    socket.send(pack(message))
    return unpack_reply(socket.recv(5))


def kind(reply: Dict[str, Any]) -> str:
    """What kind of error a reply is; "" if it is none."""
    return reply["error"]["kind"] if "error" in reply else ""
