"""One client's connection: its requests in order, its replies as they come."""

from __future__ import annotations

import asyncio
import contextlib
from typing import Any, Dict, Set

from websockets.asyncio.server import ServerConnection
from websockets.exceptions import ConnectionClosed

from probe_bridge.command_log import CommandLog
from probe_bridge.errors import BridgeError
from probe_bridge.replies import failed
from probe_bridge.requests import Bare, Hello, Renew, Request, read_request
from probe_bridge.robot import Robot
from probe_bridge.wire import pack, unpack_request

_AT_ONCE = 16
"""Requests that may wait for their replies at the same time."""


_LAST = 1.0
"""Seconds that answers nobody will hear may take before the next client is let in."""


class Session:
    """Serves a connection until it closes. The robot stops with it.

    Args:
        robot: Whom the requests are for.
        connection: To an authorised client.
        log: Gets a line for all that is commanded, and what came of it.
    """

    def __init__(self, robot: Robot, connection: ServerConnection, log: CommandLog) -> None:
        self._robot = robot
        self._log = log
        self._connection = connection
        self._seq = 0
        self._greeted = False
        self._answers: Set[asyncio.Task[None]] = set()

    async def run(self) -> None:
        """Read requests until the client leaves."""
        try:
            with contextlib.suppress(BridgeError):  # the first motion is refused
                self._log.add("connected", client=str(self._connection.remote_address))
            async for data in self._connection:
                await self._receive(data)
        except ConnectionClosed:
            pass  # the robot stops below, however the connection ended
        finally:
            with contextlib.suppress(BridgeError):  # the robot has logged it
                self._robot.halt("lost", "The client's connection closed.")
            if self._answers:
                await asyncio.wait(self._answers, timeout=_LAST)
            with contextlib.suppress(BridgeError):  # the next client will hear of it
                self._log.add("left")

    async def _receive(self, data: object) -> None:
        """Begin to answer a request; never waits for the robot."""
        seq = 0
        try:
            message = unpack_request(data)
            number = message.get("seq")
            seq = number if type(number) is int and 0 < number < 2**53 else 0
            seq, request = read_request(message, len(self._robot.config.chain.joints))
            self._check(seq, request)
        except BridgeError as error:
            with contextlib.suppress(BridgeError):  # what moves nothing needs no line
                self._log.add("refused", seq=seq, text=error.text)
            await self._send({"seq": seq, "error": failed(error)})
            return
        task = asyncio.ensure_future(self._answer(seq, request, message))
        self._answers.add(task)
        task.add_done_callback(self._answers.discard)

    def _check(self, seq: int, request: Request) -> None:
        if seq <= self._seq:
            raise BridgeError("refused", f"Request {seq} does not come after {self._seq}.")
        self._seq = seq
        if not self._greeted and not isinstance(request, Hello):
            raise BridgeError("refused", "The first request must be hello.")
        stops = isinstance(request, Bare) and request.do == "stop"
        urgent = stops or isinstance(request, Renew)
        if len(self._answers) >= _AT_ONCE and not urgent:
            raise BridgeError("busy", f"{_AT_ONCE} requests already wait for their replies.")

    async def _answer(self, seq: int, request: Request, message: Dict[str, Any]) -> None:
        try:
            result = await self._logged(seq, request, message)
        except BridgeError as error:
            await self._send({"seq": seq, "error": failed(error)})
            if error.kind == "version":
                await self._connection.close(1008, "another version")
            return
        self._greeted = self._greeted or isinstance(request, Hello)
        await self._send({"seq": seq, "result": result})

    async def _logged(self, seq: int, request: Request, message: Dict[str, Any]) -> Dict[str, Any]:
        """What the robot answers; it moves only if that can be logged, and stops in any case."""
        do, error = str(message["do"]), None
        result: Dict[str, Any] = {}
        arguments = {key: message[key] for key in message if key not in ("do", "seq")}
        if do != "stop":
            self._log.asked(do, seq, arguments)
        try:
            result = await self._robot.answer(request)
        except BridgeError as failure:
            error = failure
        if do == "stop":
            self._log.asked(do, seq, arguments)
        self._log.ended(do, seq, error)
        if error:
            raise error
        return result

    async def _send(self, message: Dict[str, Any]) -> None:
        with contextlib.suppress(ConnectionClosed):  # nobody is left to hear it
            await self._connection.send(pack(message))
