"""A local server that answers as a script says, in the protocol in which it is asked."""

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
    """What one request gets: words, a refusal, or an error's status; after a wait in seconds.

    Calls are names and arguments, the latter as they stand on the wire; in OpenAI's chat their ids
    may be given, and how many choices there are. The words of an error may be, too.
    """

    words: str | None = None
    refusal: str | None = None
    status: int = 200
    wait: float = 0.0
    calls: tuple[tuple[str, str], ...] = ()
    ids: tuple[str, ...] = ()
    choices: int = 1
    error: str = ""


@dataclass
class Served:
    """A running server: its address, how many requests it got, their bodies if it keeps them."""

    url: str
    requests: int = 0
    bodies: list[dict[str, object]] = field(default_factory=list[dict[str, object]])


def said(path: str, number: int, reply: Reply) -> dict[str, object]:
    """A reply as the protocol of an address has it."""
    if path.endswith("/responses"):
        return in_responses(number, reply)
    if path.endswith("/messages"):
        return in_messages(number, reply)
    if "generateContent" in path:
        return in_contents(reply)
    return in_chat(number, reply)


def in_chat(number: int, reply: Reply) -> dict[str, object]:
    """OpenAI's chat completions."""
    message: dict[str, object] = {
        "role": "assistant", "content": reply.words, "refusal": reply.refusal
    }  # fmt: skip
    if reply.calls:
        message["tool_calls"] = [
            {
                "id": reply.ids[n] if reply.ids else f"r{number}c{n}",
                "type": "function",
                "function": {"name": name, "arguments": text},
            }
            for n, (name, text) in enumerate(reply.calls)
        ]
    choice = {
        "index": 0,
        "message": message,
        "finish_reason": "tool_calls" if reply.calls else "stop",
    }
    usage = {"prompt_tokens": 100, "completion_tokens": 10, "total_tokens": 110}
    return {
        "id": "x", "object": "chat.completion", "created": 0, "model": "m",
        "choices": [choice] * reply.choices, "usage": usage,
    }  # fmt: skip


def in_responses(number: int, reply: Reply) -> dict[str, object]:
    """OpenAI's responses."""
    output: list[object] = [
        {
            "type": "function_call", "id": f"fc_{number}_{n}", "call_id": f"r{number}c{n}",
            "name": name, "arguments": text, "status": "completed",
        }
        for n, (name, text) in enumerate(reply.calls)
    ]  # fmt: skip
    if reply.words:
        content = [{"type": "output_text", "text": reply.words, "annotations": []}]
        output.insert(0, {
            "type": "message", "id": f"msg_{number}", "role": "assistant",
            "status": "completed", "content": content,
        })  # fmt: skip
    usage = {
        "input_tokens": 100, "output_tokens": 10, "total_tokens": 110,
        "input_tokens_details": {"cached_tokens": 0, "cache_write_tokens": 0},
        "output_tokens_details": {"reasoning_tokens": 0},
    }  # fmt: skip
    return {
        "id": f"resp_{number}", "object": "response", "created_at": 0, "model": "m",
        "status": "completed", "output": output, "usage": usage, "error": None,
        "incomplete_details": None, "instructions": None, "metadata": {},
        "parallel_tool_calls": False, "temperature": 1, "tool_choice": "auto", "tools": [],
        "top_p": 1,
    }  # fmt: skip


def in_messages(number: int, reply: Reply) -> dict[str, object]:
    """Anthropic's messages."""
    content: list[object] = [{"type": "text", "text": reply.words}] if reply.words else []
    content += [
        {"type": "tool_use", "id": f"r{number}c{n}", "name": name, "input": json.loads(text)}
        for n, (name, text) in enumerate(reply.calls)
    ]
    return {
        "id": f"msg_{number}", "type": "message", "role": "assistant", "model": "m",
        "content": content, "stop_reason": "tool_use" if reply.calls else "end_turn",
        "stop_sequence": None, "usage": {"input_tokens": 100, "output_tokens": 10},
    }  # fmt: skip


def in_contents(reply: Reply) -> dict[str, object]:
    """Google's generateContent."""
    parts: list[object] = [{"text": reply.words}] if reply.words else []
    parts += [
        {"functionCall": {"name": name, "args": json.loads(text)}} for name, text in reply.calls
    ]
    candidate = {"content": {"role": "model", "parts": parts}, "finishReason": "STOP", "index": 0}
    usage = {"promptTokenCount": 100, "candidatesTokenCount": 10, "totalTokenCount": 110}
    return {"candidates": [candidate], "usageMetadata": usage, "modelVersion": "m"}


@contextmanager
def serving(
    script: Callable[[int, dict[str, object]], Reply], *, keep: bool = True
) -> Generator[Served]:
    """Serve until the block ends; the script is given each request's number and body.

    Args:
        script: Answers.
        keep: Keep all bodies; with pictures, those of long conversations take gigabytes.
    """
    served = Served("")
    lock = threading.Lock()

    class Handler(BaseHTTPRequestHandler):
        def do_POST(self) -> None:
            body = json.loads(self.rfile.read(int(self.headers["Content-Length"])))
            with lock:
                number = served.requests
                served.requests += 1
                if keep:
                    served.bodies.append(body)
            reply = script(number, body)
            time.sleep(reply.wait)
            whole = said(self.path, number, reply)
            if reply.status != 200:
                whole = {"error": {"message": reply.error or f"status {reply.status}", "type": "x"}}
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
