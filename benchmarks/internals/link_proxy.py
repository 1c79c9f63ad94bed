"""Stands between a robot's client and its bridge, and does to the link what networks do."""

from __future__ import annotations

import queue
import random
import socket
import struct
import threading
import time
from collections.abc import Iterator
from contextlib import suppress
from typing import BinaryIO, Literal

import msgpack

Harm = Literal["none", "silent", "late", "lossy"]

LATE = 2.0
"""Seconds by which each message is late, in each direction."""

LOST = 0.1
"""Share of messages that are lost, in each direction."""

_CLOSE = 8


class LinkProxy:
    """Listens on this machine and passes websocket messages on, whole or not at all.

    Args:
        port: Of the bridge.
        seed: Of what is lost.

    Attributes:
        harm: What is done to messages from now on.
        heard: When the bridge was sent what: (time.monotonic(), what was asked).
    """

    def __init__(self, port: int, seed: int) -> None:
        self.harm: Harm = "none"
        self.heard: list[tuple[float, str]] = []
        self._port = port
        self._rng = random.Random(seed)
        self._sockets: list[socket.socket] = []
        self._listener = socket.create_server(("127.0.0.1", 0))
        self.address = f"ws://127.0.0.1:{self._listener.getsockname()[1]}"
        threading.Thread(target=self._accept, daemon=True).start()

    def cut(self) -> None:
        """Break all connections, as if one end had reset them."""
        for each in self._sockets:
            each.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0))
            with suppress(OSError):  # a thread that reads from it keeps a closed socket open
                each.shutdown(socket.SHUT_RD)
            each.close()
        self._sockets.clear()

    def close(self) -> None:
        """Break what is left, and listen no more."""
        self._listener.close()
        for each in self._sockets:
            each.close()

    def _accept(self) -> None:
        while True:
            try:
                client, _ = self._listener.accept()
                bridge = socket.create_connection(("127.0.0.1", self._port))
            except OSError:
                return
            self._sockets += [client, bridge]
            self._pass(client, bridge, asks=True)
            self._pass(bridge, client, asks=False)

    def _pass(self, here: socket.socket, there: socket.socket, *, asks: bool) -> None:
        due: queue.Queue[tuple[float, bytes, str]] = queue.Queue()
        threading.Thread(target=self._read, args=(here, due, asks), daemon=True).start()
        threading.Thread(target=self._write, args=(there, due), daemon=True).start()

    def _read(
        self, here: socket.socket, due: queue.Queue[tuple[float, bytes, str]], asks: bool
    ) -> None:
        try:
            with here.makefile("rb") as stream:
                due.put((0.0, _handshake(stream), ""))
                for kind, whole, payload in _messages(stream):
                    lost = self.harm == "lossy" and kind != _CLOSE and self._rng.random() < LOST
                    if self.harm != "silent" and not lost:
                        wait = LATE if self.harm == "late" else 0.0
                        do = _do(payload) if asks and kind == 2 else ""
                        due.put((time.monotonic() + wait, whole, do))
        except (OSError, EOFError, ValueError):
            pass
        if self.harm != "silent":  # nobody hears a hang-up over a cable that was pulled
            due.put((time.monotonic(), b"", ""))

    def _write(self, there: socket.socket, due: queue.Queue[tuple[float, bytes, str]]) -> None:
        while True:
            at, data, do = due.get()
            time.sleep(max(0.0, at - time.monotonic()))
            try:
                if not data:
                    there.shutdown(socket.SHUT_WR)
                    return
                there.sendall(data)
            except OSError:
                return
            if do:
                self.heard.append((time.monotonic(), do))


def _handshake(stream: BinaryIO) -> bytes:
    lines = list(iter(stream.readline, b"\r\n"))
    return b"".join(lines) + b"\r\n"


def _messages(stream: BinaryIO) -> Iterator[tuple[int, bytes, bytes]]:
    """Opcode, bytes and unmasked payload of each frame (RFC 6455, section 5.2)."""
    while True:
        head = _exactly(stream, 2)
        length, masked = head[1] & 127, head[1] & 128
        if length >= 126:
            more = _exactly(stream, 2 if length == 126 else 8)
            head, length = head + more, int.from_bytes(more, "big")
        mask = _exactly(stream, 4) if masked else bytes(4)
        data = _exactly(stream, length)
        whole = head + (mask if masked else b"") + data
        plain = bytes(v ^ mask[i % 4] for i, v in enumerate(data)) if masked else data
        yield head[0] & 15, whole, plain


def _exactly(stream: BinaryIO, count: int) -> bytes:
    data = stream.read(count)
    if len(data) < count:
        raise EOFError
    return data


def _do(payload: bytes) -> str:
    return str(msgpack.unpackb(payload).get("do", "?"))
