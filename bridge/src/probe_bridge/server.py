"""Listens for one authorised client at a time."""

from __future__ import annotations

import asyncio
import hmac
import http
import ssl
from dataclasses import dataclass
from typing import Optional

from websockets.asyncio.server import Server, ServerConnection, serve
from websockets.http11 import Request, Response

from probe_bridge.command_log import NOWHERE, CommandLog
from probe_bridge.errors import BridgeError
from probe_bridge.replies import failed
from probe_bridge.robot import Robot
from probe_bridge.session import Session
from probe_bridge.wire import MAX_REQUEST, pack

LOOPBACK = "127.0.0.1"
PORT = 8731

_PATIENCE = 2.0
"""Seconds that a client waits for the place of one that is just leaving."""


@dataclass(frozen=True)
class Address:
    """Where to listen, and with what.

    Attributes:
        host, port: By default only this computer can connect; port 0 is any free one.
        tls: Of the server's certificate; without it, nothing is encrypted.
    """

    host: str = LOOPBACK
    port: int = PORT
    tls: Optional[ssl.SSLContext] = None


async def listen(
    robot: Robot, token: str, address: Address, log: Optional[CommandLog] = None
) -> Server:
    """Serve a robot to whoever has the token; returns once it listens.

    Closing what this returns ends all connections. The robot is stopped with each.
    """
    gate = _Gate(robot, token, log or CommandLog(NOWHERE))
    return await serve(
        gate.serve,
        address.host,
        address.port,
        ssl=address.tls,
        process_request=gate.admit,
        max_size=MAX_REQUEST,
        compression=None,  # pictures are compressed already
        ping_interval=2.0,
        ping_timeout=4.0,  # so that a dead client's place soon becomes free
    )


class _Gate:
    """Lets one client in at a time, and only with the token."""

    def __init__(self, robot: Robot, token: str, log: CommandLog) -> None:
        self._robot = robot
        self._log = log
        self._expected = f"Bearer {token}".encode()
        self._place = asyncio.Lock()

    def admit(self, connection: ServerConnection, request: Request) -> Optional[Response]:
        """Answer 401 to whoever lacks the token, before the connection is a websocket."""
        given = request.headers.get_all("Authorization")
        # Bytes beyond ASCII may have become lone surrogates.
        sent = given[0].encode("utf-8", "surrogatepass") if len(given) == 1 else b""
        if hmac.compare_digest(sent, self._expected):
            return None
        return connection.respond(http.HTTPStatus.UNAUTHORIZED, "The token is missing or wrong.\n")

    async def serve(self, connection: ServerConnection) -> None:
        try:
            await asyncio.wait_for(self._place.acquire(), _PATIENCE)
        except asyncio.TimeoutError:
            error = BridgeError("taken", "Another client is connected.", "Wait until it leaves.")
            await connection.send(pack({"seq": 0, "error": failed(error)}))
            await connection.close(1013, "another client is connected")
            return
        try:
            await Session(self._robot, connection, self._log).run()
        finally:
            self._place.release()
