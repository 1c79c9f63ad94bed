"""Those who come in: the official client, called from ordinary code, and one without manners."""

from __future__ import annotations

import base64
import io
import json
import queue
import subprocess
import sys
import threading
from collections.abc import Generator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from anyio.from_thread import BlockingPortal, start_blocking_portal
from mcp import StdioServerParameters
from mcp.client import Client
from mcp_types import CallToolResult, ImageContent, TextContent
from PIL import Image

from probe.types import Array

PATIENCE = 60.0
"""Seconds after which a silent server counts as dead."""


@dataclass(frozen=True)
class Reply:
    """What a call came to, for a client."""

    text: str
    picture: Array | None
    error: bool

    @staticmethod
    def of(result: CallToolResult) -> Reply:
        """The reply in a result that holds one text and at most one picture."""
        text, *pictures = result.content
        assert isinstance(text, TextContent) and len(pictures) < 2
        assert result.structured_content is None
        seen = [decoded(p.data) for p in pictures if isinstance(p, ImageContent)]
        return Reply(text.text, seen[0] if seen else None, bool(result.is_error))


class Player:
    """The official client, call by call."""

    def __init__(self, portal: BlockingPortal, client: Client) -> None:
        self.portal = portal
        self.client = client

    def call(self, name: str, **arguments: object) -> Reply:
        return Reply.of(self.portal.call(self.client.call_tool, name, arguments))


@contextmanager
def playing(
    *command: object, env: Mapping[str, str] | None = None, mode: str = "auto"
) -> Generator[Player]:
    """Start a server with the official client, and leave it in the end."""
    first, *rest = [sys.executable, *map(str, command)]
    server = StdioServerParameters(command=first, args=rest, env=dict(env or {}))
    with start_blocking_portal() as portal:
        client = Client(server, mode=mode)
        with portal.wrap_async_context_manager(client):
            yield Player(portal, client)


def decoded(data: str) -> Array:
    """The pixels of a picture as it is sent; nothing else may be in it."""
    with Image.open(io.BytesIO(base64.b64decode(data))) as image:
        assert set(image.info) <= {"jfif", "jfif_version", "jfif_unit", "jfif_density"}
        return np.asarray(image)


@dataclass
class Wire:
    """Speaks the bare protocol, so that it may be broken; keeps all that it is sent."""

    process: subprocess.Popen[bytes]
    seen: list[dict[str, Any]] = field(default_factory=list[dict[str, Any]])
    asked: int = 0
    called: int = 0

    def __post_init__(self) -> None:
        self._lines: queue.Queue[bytes] = queue.Queue()
        threading.Thread(target=self._read, daemon=True).start()

    def send(self, line: bytes) -> None:
        """A line, whatever it says."""
        assert self.process.stdin is not None
        self.process.stdin.write(line + b"\n")
        self.process.stdin.flush()

    def ask(self, method: str, params: object = None) -> dict[str, Any]:
        """A request, and what it is answered with: a result or an error."""
        self.asked += 1
        request = {"jsonrpc": "2.0", "id": self.asked, "method": method, "params": params}
        self.send(json.dumps(request).encode())
        while True:
            message = json.loads(self._lines.get(timeout=PATIENCE))
            self.seen.append(message)
            if message.get("id") == self.asked:
                return message

    def call(self, name: object, arguments: object) -> dict[str, Any]:
        self.called += 1
        return self.ask("tools/call", {"name": name, "arguments": arguments})

    def greet(self) -> None:
        """The handshake of earlier protocols."""
        us = {"name": "test", "version": "0"}
        told = {"protocolVersion": "2025-06-18", "capabilities": {}, "clientInfo": us}
        assert "result" in self.ask("initialize", told)
        self.send(json.dumps({"jsonrpc": "2.0", "method": "notifications/initialized"}).encode())

    def _read(self) -> None:
        assert self.process.stdout is not None
        for line in self.process.stdout:
            self._lines.put(line)


@contextmanager
def wired(*command: object) -> Generator[Wire]:
    """Start a server, shake hands, and close its input in the end."""
    start: Sequence[str] = [sys.executable, *map(str, command)]
    pipe = subprocess.PIPE
    with subprocess.Popen(start, stdin=pipe, stdout=pipe, stderr=pipe) as process:
        wire = Wire(process)
        wire.greet()
        yield wire
        assert process.stdin is not None
        process.stdin.close()
        process.wait(PATIENCE)
