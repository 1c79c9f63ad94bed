"""What can be sent to the page of `probe human`, and down the line of `probe serve`."""

from __future__ import annotations

import http.client
import json
import subprocess
import sys
from collections.abc import Generator, Iterator
from contextlib import contextmanager
from itertools import product
from pathlib import Path
from typing import Any

import named
from command import PATIENCE, surroundings
from verdict import Attack

PAGE, LINE = "the page's port", "the line of MCP"
_JSON = {"Content-Type": "application/json"}
_CALL = {"name": "Eve", "turn": 0, "tool": "push", "arguments": {}}
_STRANGE: list[Any] = [
    None, True, -1, 10**400, 1e308, "", "\x00", "\ud800", "\u202e", named.NAME, "A" * 10_000, [],
    {}, [[]], {"a": {}}, ["\x1b[2J"],
]  # fmt: skip


@contextmanager
def _human(folder: Path) -> Generator[tuple[subprocess.Popen[str], int]]:
    words = ["human", "demo", "--port", "0", "--seats", "1", "--out", str(folder)]
    process = subprocess.Popen(
        [sys.executable, "-m", "probe", *words],
        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=surroundings({}),
    )  # fmt: skip
    try:
        assert process.stdout is not None
        address = next(word for word in process.stdout.readline().split() if "http" in word)
        yield process, int(address.rstrip("/").rpartition(":")[2])
    finally:
        process.terminate()
        process.communicate(timeout=PATIENCE)


def attack_page(folder: Path) -> Iterator[Attack]:
    """Requests with a wrong host, origin, type, path, length or body; then some as they should be.

    Args:
        folder: For the server; nothing may change beside it.
    """
    before = set(folder.parent.rglob("*"))
    with _human(folder) as (process, port):
        for name, method, path, headers, body in _requests(port):
            yield _asked(port, name, method, path, headers, body)
        try:
            named.plays(port)
        except OSError as error:
            yield Attack(PAGE, f"a person called {named.NAME}", "crashed", repr(error))
            return
        polite = _asked(port, "enter", "POST", "/seat/enter", _JSON, b'{"name": "Ada"}')
        well = process.poll() is None and polite.verdict == "read wrongly"
        verdict = "harmless" if well else "crashed"
        yield Attack(PAGE, "a visitor after all that", verdict, polite.detail)
    yield named.judged(PAGE, folder.parent, folder, before)


_Request = tuple[str, str, str, dict[str, str], bytes | None]


def _requests(port: int) -> Iterator[_Request]:
    enter = b'{"name": "Eve"}'
    for host in ("evil.example", "127.0.0.1.evil.example", "", "0.0.0.0", "[::1]", "localhost@x"):
        yield f"host {host!r}", "GET", "/", {"Host": host}, None
        yield f"host {host!r}, POST", "POST", "/seat/enter", {**_JSON, "Host": host}, enter
    for origin in ("null", "http://evil.example", "https://localhost", f"http://127.0.0.1:{port}1"):
        yield f"origin {origin}", "POST", "/seat/enter", {**_JSON, "Origin": origin}, enter
    for kind in ("text/plain", "", "application/x-www-form-urlencoded", "multipart/form-data"):
        yield f"type {kind!r}", "POST", "/seat/enter", {"Content-Type": kind}, enter
    for path in ("/../../etc/passwd", "/static/../../../etc/passwd", "/static/%2e%2e/app.py",
                 "/seat/picture?name=Eve&number=-1", "/seat/state", "/%00", "//evil.example/",
                 "/static//etc/passwd", "/seat/picture?name=%ED%A0%80&number=0"):  # fmt: skip
        yield f"path {path}", "GET", path, {}, None
    for method in ("PUT", "DELETE", "OPTIONS", "TRACE", "PATCH"):
        yield f"method {method}", method, "/seat/enter", _JSON, enter
    yield "a long body", "POST", "/seat/enter", _JSON, b'{"name": "' + b"A" * 100_000 + b'"}'
    yield "deep", "POST", "/seat/enter", _JSON, b"[" * 19_000
    yield "no JSON", "POST", "/seat/enter", _JSON, b"\xff\xfe{"
    yield from _bodies()


def _bodies() -> Iterator[_Request]:
    for strange in _STRANGE:
        words = repr(strange)[:30]
        if strange == named.NAME:  # a good name: what becomes of it is looked at apart
            fields = "turn", "tool", "arguments"
        else:
            fields = "turn", "tool", "arguments", "name"
            body = json.dumps({"name": strange}).encode()
            yield f"name {words}", "POST", "/seat/enter", _JSON, body
        for field in fields:
            body = json.dumps({**_CALL, field: strange}).encode()
            yield f"{field} {words}", "POST", "/seat/call", _JSON, body


def _asked(
    port: int, name: str, method: str, path: str, headers: dict[str, str], body: bytes | None
) -> Attack:
    wire = http.client.HTTPConnection("127.0.0.1", port, timeout=PATIENCE)
    try:
        wire.putrequest(method, path, skip_host="Host" in headers, skip_accept_encoding=True)
        for header, value in headers.items():
            wire.putheader(header, value)
        wire.putheader("Content-Length", str(len(body or b"")))
        wire.endheaders(body)
        response = wire.getresponse()
        status, said = response.status, response.read(300).decode(errors="replace")
    except (OSError, http.client.HTTPException) as error:
        return Attack(PAGE, name, "crashed", repr(error))
    finally:
        wire.close()
    if status >= 500:
        return Attack(PAGE, name, "crashed", f"{status} {said}")
    return Attack(PAGE, name, "refused" if status >= 400 else "read wrongly", f"{status} {said}")


class _Wire:
    """Speaks the bare protocol, so that it may be broken."""

    def __init__(self, process: subprocess.Popen[bytes]) -> None:
        assert process.stdin is not None and process.stdout is not None
        self._to, self._from = process.stdin, process.stdout
        self._asked = 0

    def send(self, line: bytes) -> None:
        self._to.write(line + b"\n")
        self._to.flush()

    def ask(self, method: str, params: object = None) -> dict[str, Any]:
        """What a request is answered with; nothing once the server has gone."""
        self._asked += 1
        request = {"jsonrpc": "2.0", "id": self._asked, "method": method, "params": params}
        self.send(json.dumps(request).encode())
        for line in self._from:
            if (reply := json.loads(line)).get("id") == self._asked:
                return reply
        return {}

    def greet(self) -> None:
        us = {"name": "attacks", "version": "0"}
        told = {"protocolVersion": "2025-06-18", "capabilities": {}, "clientInfo": us}
        self.ask("initialize", told)
        self.send(b'{"jsonrpc": "2.0", "method": "notifications/initialized"}')

    def close(self) -> None:
        self._to.close()


def attack_line(folder: Path) -> Iterator[Attack]:
    """Lines that are no requests, and calls without sense; then a polite end."""
    words = [sys.executable, "-m", "probe", "serve", "--out", str(folder)]
    pipe, nothing = subprocess.PIPE, subprocess.DEVNULL
    with subprocess.Popen(words, stdin=pipe, stdout=pipe, stderr=nothing) as process:
        wire = _Wire(process)
        wire.greet()
        for line in _LINES:
            wire.send(line)
            alive = "result" in wire.ask("ping")
            yield Attack(LINE, repr(line[:40]), "harmless" if alive else "crashed")
        for tool, strange in product(_TOOLS, _STRANGE):
            # A lone surrogate is no Unicode: the protocol's own layer drops the whole line.
            if strange != "\ud800":
                reply = wire.ask("tools/call", {"name": tool, "arguments": {"object_id": strange}})
                refused = "error" in reply or reply.get("result", {}).get("isError", False)
                verdict = "refused" if refused else "read wrongly"
                yield Attack(LINE, f"{tool} {repr(strange)[:30]}", verdict, str(reply)[:200])
        wire.close()
        process.wait(PATIENCE)
        verdict = "harmless" if process.returncode == 0 else "crashed"
        yield Attack(LINE, "the end", verdict, f"exit status {process.returncode}")


_TOOLS = ("find_object", "grasp_and_remove", "push", "answer_question", "no_such_tool")
_LINES = (
    b"", b"{", b"\xff\xfe\x00", b"[1, 2]", b"null", b'{"jsonrpc": "2.0"}', b'{"a":' * 100_000,
    b'{"jsonrpc": "2.0", "id": {"a": 1}, "method": "tools/call"}',
    b'{"jsonrpc": "2.0", "id": 900003, "method": "\\ud800", "params": []}',
    b'{"jsonrpc": "2.0", "id": 900004, "result": {}}',
    b'{"jsonrpc": "2.0", "method": "notifications/cancelled", "params": {"requestId": []}}',
    b"A" * 1_000_000, b"\x00" * 100, b'{"jsonrpc": "2.0", "id": 1e999, "method": "ping"}',
)  # fmt: skip
