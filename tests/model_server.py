"""A local server that speaks OpenAI's chat protocol and answers as a script says."""

from __future__ import annotations

import json
import threading
import time
from collections.abc import Callable, Generator
from contextlib import contextmanager
from dataclasses import dataclass, field
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer


@dataclass(frozen=True)
class Reply:
    """What one request gets: words, a refusal, or an error's status; after a wait in seconds."""

    words: str | None = None
    refusal: str | None = None
    status: int = 200
    wait: float = 0.0


@dataclass
class Served:
    """A running server: its address and the bodies of all requests it got."""

    url: str
    bodies: list[dict[str, object]] = field(default_factory=list[dict[str, object]])


@contextmanager
def serving(script: Callable[[int, dict[str, object]], Reply]) -> Generator[Served]:
    """Serve until the block ends; the script is given each request's number and body."""
    served = Served("")
    lock = threading.Lock()

    class Handler(BaseHTTPRequestHandler):
        def do_POST(self) -> None:
            body = json.loads(self.rfile.read(int(self.headers["Content-Length"])))
            with lock:
                number = len(served.bodies)
                served.bodies.append(body)
            reply = script(number, body)
            time.sleep(reply.wait)
            message = {"role": "assistant", "content": reply.words, "refusal": reply.refusal}
            choice = {"index": 0, "message": message, "finish_reason": "stop"}
            whole: dict[str, object] = {
                "id": "x", "object": "chat.completion", "created": 0, "model": "m",
                "choices": [choice],
            }  # fmt: skip
            if reply.status != 200:
                whole = {"error": {"message": f"status {reply.status}", "type": "x"}}
            content = json.dumps(whole).encode()
            try:
                self.send_response(reply.status)
                self.send_header("Content-Type", "application/json")
                self.send_header("Content-Length", str(len(content)))
                self.send_header("Retry-After", "0")
                self.end_headers()
                self.wfile.write(content)
            except OSError:
                pass  # the client has gone: it waited long enough

        def log_message(self, format: str, *args: object) -> None:
            """Say nothing."""

    server = ThreadingHTTPServer(("127.0.0.1", 0), Handler)
    served.url = f"http://127.0.0.1:{server.server_port}/v1"
    threading.Thread(target=server.serve_forever, daemon=True).start()
    try:
        yield served
    finally:
        server.shutdown()
        server.server_close()
