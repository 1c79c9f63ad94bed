"""A client's connection: requests out, replies back, by number. Knows no robot."""

from __future__ import annotations

import socket
import ssl
import threading
import time
from contextlib import ExitStack
from pathlib import Path
from typing import Any, Dict, Optional, cast
from urllib.parse import urlsplit

from websockets.exceptions import InvalidStatus, WebSocketException
from websockets.sync.client import ClientConnection, connect

from probe_bridge.command_log import CommandLog
from probe_bridge.errors import BridgeError
from probe_bridge.replies import error_of
from probe_bridge.wire import MAX_REPLY, pack, unpack_reply

OPEN_TIME = 10.0
"""Seconds that connecting may take."""

_AGAIN = "Connect again when you know that the robot is well."


class Reply:
    """What will answer one request.

    Args:
        do: What was asked.
    """

    def __init__(self, do: str) -> None:
        self.do = do
        self._came = threading.Event()
        self._result: Dict[str, Any] = {}
        self._error: Optional[BridgeError] = None

    def came(self, seconds: float = 0.0) -> bool:
        """Whether it has come; waits for it at most so long."""
        return self._came.wait(seconds)

    def deliver(self, result: Dict[str, Any], error: Optional[BridgeError]) -> None:
        self._result, self._error = result, error
        self._came.set()

    @property
    def result(self) -> Dict[str, Any]:
        """Raises the BridgeError that came instead, if one did."""
        if self._error:
            raise self._error
        return self._result


class Link:
    """An open connection to a bridge. It never reconnects by itself.

    Args:
        address: ws://HOST:PORT, or wss://HOST:PORT with TLS.
        token: The bridge's token.
        certificate: Of the bridge, if no public authority vouches for it.
        log: Gets a line for all that is commanded, and what came of it.

    Raises:
        BridgeError: "unauthorized" or "lost".
    """

    def __init__(
        self, address: str, token: str, certificate: Optional[Path], log: CommandLog
    ) -> None:
        self._log = log
        self._lock = threading.Lock()
        self._seq = 0
        self._waiting: Dict[int, Reply] = {}
        self._lost: Optional[BridgeError] = None
        self._closing = ExitStack()
        try:
            self._socket = _open(self._closing, address, token, certificate)
        except InvalidStatus as error:
            if error.response.status_code == 401:
                raise BridgeError("unauthorized", f"{address} refuses the token.") from error
            raise BridgeError("lost", f"{address} is no bridge: {error}.") from error
        except (OSError, ValueError, WebSocketException) as error:
            raise BridgeError("lost", f"{address} can't be reached: {error}.") from error
        self._reader = threading.Thread(target=self._read, name="replies", daemon=True)
        self._reader.start()

    def send(self, do: str, **arguments: object) -> Reply:
        """Send a request; its reply comes later.

        Raises:
            BridgeError: "lost", or "fault" if the log can't be written; then nothing was sent,
                unless it asks to stop.
        """
        reply = Reply(do)
        with self._lock:
            if self._lost:
                raise self._lost
            self._seq += 1
            if do != "stop":
                self._log.asked(do, self._seq, arguments)
            self._waiting[self._seq] = reply
            try:
                self._socket.send(pack({"seq": self._seq, "do": do, **arguments}))
            except (OSError, WebSocketException) as error:
                raise BridgeError("lost", f"The connection broke: {error}.", _AGAIN) from error
            if do == "stop":
                self._log.asked(do, self._seq, arguments)
        return reply

    @property
    def open(self) -> bool:
        """Whether requests can still be sent."""
        return self._lost is None

    def close(self) -> None:
        """Leave; the robot stops."""
        self._closing.close()
        self._reader.join()

    def _read(self) -> None:
        error = BridgeError("lost", "The bridge closed the connection.", _AGAIN)
        try:
            for data in self._socket:
                message = unpack_reply(data)
                seq, failure = message.get("seq"), message.get("error")
                if seq == 0:
                    error = error_of(failure)
                    break
                self._deliver(cast(int, seq), message.get("result"), failure)
        except BridgeError as wrong:
            error = BridgeError("lost", f"The bridge answers nonsense: {wrong}", _AGAIN)
        except (OSError, WebSocketException) as broken:
            error = BridgeError("lost", f"The connection broke: {broken}.", _AGAIN)
        with self._lock:
            self._lost = error
            waiting, self._waiting = self._waiting, {}
        for seq, reply in waiting.items():
            self._end(seq, reply, {}, error)

    def _deliver(self, seq: int, result: object, failure: object) -> None:
        with self._lock:
            reply = self._waiting.pop(seq, None)
        if reply:
            values = cast("Dict[str, Any]", result) if isinstance(result, dict) else {}
            self._end(seq, reply, values, None if failure is None else error_of(failure))

    def _end(
        self, seq: int, reply: Reply, values: Dict[str, Any], error: Optional[BridgeError]
    ) -> None:
        try:
            self._log.ended(reply.do, seq, error)
        except BridgeError as unwritten:
            error = error or unwritten
        reply.deliver(values, error)


def _open(
    closing: ExitStack, address: str, token: str, certificate: Optional[Path]
) -> ClientConnection:
    """Connect; the socket is opened here so that no proxy and no redirection gets the token."""
    url = urlsplit(address)
    if url.scheme not in ("ws", "wss") or not url.hostname or not url.port:
        raise ValueError("an address looks like ws://HOST:PORT or wss://HOST:PORT")
    tls = None
    if url.scheme == "wss":
        tls = ssl.create_default_context(cafile=str(certificate) if certificate else None)
    end = time.monotonic() + OPEN_TIME
    connection = socket.create_connection((url.hostname, url.port), OPEN_TIME)
    connection.settimeout(None)
    return closing.enter_context(
        connect(
            address,
            sock=connection,
            ssl=tls,
            additional_headers={"Authorization": f"Bearer {token}"},
            compression=None,
            max_size=MAX_REPLY,
            open_timeout=max(0.1, end - time.monotonic()),
            close_timeout=2.0,
        )
    )
