"""A model behind OpenAI's protocol, for machines on which vLLM can't run."""

from __future__ import annotations

import asyncio
import json
import socket
import time
import uuid
from collections.abc import AsyncGenerator, Generator, Mapping
from contextlib import asynccontextmanager, contextmanager, suppress
from importlib import import_module
from threading import Event
from typing import Any, cast

from probe.errors import BadData, MissingExtra, ProbeError
from probe.train.serve.speaking import ConversationTooLong, GeneratedReply, ServedModel
from probe.train.tune.conversations import NotUnderstood

_LOOPBACK = "127.0.0.1"
_UNHEEDED: Mapping[str, object] = {
    "stream": False,
    "n": 1,
    "stop": [],
    "tool_choice": "auto",
    "response_format": {"type": "text"},
    "top_p": 1,
    "frequency_penalty": 0,
    "presence_penalty": 0,
    "logit_bias": {},
    "logprobs": False,
}
"""Of a request, what changes nothing here, with the only value that wouldn't elsewhere."""


class NotServed(ProbeError):
    """A request is for another model."""

    def __init__(self, asked: object, called: str) -> None:
        super().__init__(f"There is no model {asked!r} here; this is {called!r}.")


def application(speaker: ServedModel, called: str) -> Any:
    """The server, for uvicorn.

    Args:
        speaker: Who replies.
        called: The model's name.

    Raises:
        MissingExtra: Starlette isn't installed.
    """
    parts = _web("starlette.applications"), _web("starlette.routing"), _web("starlette.responses")
    web, routing, responses = parts
    threads = _web("starlette.concurrency")

    async def complete(request: Any) -> Any:
        try:
            body = _body(await request.body(), called)
            async with _watched(request) as gone:
                said = await threads.run_in_threadpool(speaker.reply, body, gone)
        except NotServed as error:
            return responses.JSONResponse(_refusal(error, "model_not_found"), status_code=404)
        except ProbeError as error:
            code = "context_length_exceeded" if isinstance(error, ConversationTooLong) else None
            return responses.JSONResponse(_refusal(error, code), status_code=400)
        return responses.JSONResponse(completion(said, called))

    async def models(request: Any) -> Any:
        listed = [{"id": called, "object": "model", "created": 0, "owned_by": "local"}]
        return responses.JSONResponse({"object": "list", "data": listed})

    return web.Starlette(
        routes=[
            routing.Route("/v1/chat/completions", complete, methods=["POST"]),
            routing.Route("/v1/models", models),
        ]
    )


@asynccontextmanager
async def _watched(request: Any) -> AsyncGenerator[Event]:
    """What is set once a client has hung up whose request was read."""
    gone = Event()

    async def watch() -> None:
        while (await request.receive())["type"] != "http.disconnect":
            pass
        gone.set()

    watching = asyncio.create_task(watch())
    try:
        yield gone
    finally:
        watching.cancel()


@contextmanager
def reserved(port: int) -> Generator[socket.socket]:
    """A port of this machine at which nobody listens; whoever connects now is refused.

    Raises:
        BadData: It is taken, or there is none such.
    """
    with socket.socket() as held:
        held.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        try:
            held.bind((_LOOPBACK, port))
        except (OSError, OverflowError) as error:
            raise _taken(port, error) from error
        yield held


def serve(speaker: ServedModel, called: str, held: socket.socket) -> None:
    """Serve on this machine alone until it is stopped.

    Args:
        speaker: Who replies.
        called: The model's name.
        held: The port, reserved.

    Raises:
        BadData: Somebody else was faster to listen there.
        MissingExtra: uvicorn isn't installed.
    """
    web = _web("uvicorn")
    config = web.Config(application(speaker, called), log_level="warning")
    try:
        held.listen()
    except OSError as error:
        raise _taken(held.getsockname()[1], error) from error
    with suppress(KeyboardInterrupt):
        web.Server(config).run(sockets=[held])


def completion(said: GeneratedReply, called: str) -> dict[str, Any]:
    """A reply as the protocol has it."""
    message: dict[str, Any] = {"role": "assistant", "content": said.reply.words or None}
    if said.reply.calls:
        message["tool_calls"] = [
            {
                "id": f"call_{uuid.uuid4().hex[:16]}",
                "type": "function",
                "function": {"name": name, "arguments": arguments},
            }
            for name, arguments in said.reply.calls
        ]
    ending = "tool_calls" if said.reply.calls else "length" if said.cut else "stop"
    return {
        "id": f"chatcmpl-{uuid.uuid4().hex}",
        "object": "chat.completion",
        "created": int(time.time()),
        "model": called,
        "choices": [{"index": 0, "message": message, "finish_reason": ending}],
        "usage": {
            "prompt_tokens": said.tokens_in,
            "completion_tokens": said.tokens_out,
            "total_tokens": said.tokens_in + said.tokens_out,
        },
    }


def _taken(port: int, error: Exception) -> BadData:
    reason = getattr(error, "strerror", None) or str(error)
    return BadData("--port", f"{port} can't be used ({reason})", "Choose another")


def _refusal(error: ProbeError, code: str | None) -> dict[str, Any]:
    """An error as the protocol has it."""
    param = "model" if code == "model_not_found" else None
    about = {"type": "invalid_request_error", "param": param, "code": code}
    return {"error": {"message": str(error), **about}}


def _body(content: bytes, called: str) -> dict[str, Any]:
    try:
        body: Any = json.loads(content)
    except (ValueError, RecursionError) as error:
        raise NotUnderstood("it is no JSON") from error
    if not isinstance(body, dict) or "messages" not in body:
        raise NotUnderstood("it has no messages")
    asked = cast("dict[str, Any]", body)
    if asked.get("model", called) != called:
        raise NotServed(asked["model"], called)
    for option, neutral in _UNHEEDED.items():
        if asked.get(option) not in (None, neutral):
            raise NotUnderstood(f"{option} {asked[option]!r} isn't heeded here; leave it out")
    return asked


def _web(name: str) -> Any:
    try:
        return import_module(name)
    except ImportError as error:
        raise MissingExtra("A server of a model", "train") from error
