"""A model behind OpenAI's protocol, for machines on which vLLM can't run. One reply at a time."""

from __future__ import annotations

import json
import time
import uuid
from importlib import import_module
from typing import Any, cast

from probe.errors import MissingExtra, ProbeError
from probe.train.conversations import NotUnderstood
from probe.train.speaking import Said, Speaker


def application(speaker: Speaker, called: str) -> Any:
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
            body = _body(await request.body())
            said = await threads.run_in_threadpool(speaker.reply, body)
        except ProbeError as error:
            return responses.JSONResponse({"error": {"message": str(error)}}, status_code=400)
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


def serve(speaker: Speaker, called: str, port: int) -> None:
    """Serve on this machine alone until it is stopped.

    Raises:
        MissingExtra: uvicorn isn't installed.
    """
    app = application(speaker, called)
    _web("uvicorn").run(app, host="127.0.0.1", port=port, log_level="warning")


def completion(said: Said, called: str) -> dict[str, Any]:
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


def _body(content: bytes) -> dict[str, Any]:
    try:
        body: Any = json.loads(content)
    except ValueError as error:
        raise NotUnderstood("it is no JSON") from error
    if not isinstance(body, dict) or "messages" not in body:
        raise NotUnderstood("it has no messages")
    return cast("dict[str, Any]", body)


def _web(name: str) -> Any:
    try:
        return import_module(name)
    except ImportError as error:
        raise MissingExtra("A server of a model", "train") from error
