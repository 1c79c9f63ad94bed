"""Vision-language models behind OpenAI's protocol, as something that can be asked."""

from __future__ import annotations

import base64
import os
from collections.abc import Sequence
from typing import Any

from PIL import Image

from probe.errors import MissingExtra, ModelFailed
from probe.files import encode
from probe.types import Array, Ask

RETRIES = 4
"""For refusals for lack of capacity, failures of the server, and lost connections."""


def model_behind(endpoint: str, model: str, timeout: float) -> Ask:
    """A model of a server.

    The key is that of OPENAI_API_KEY; local servers take any.

    Args:
        endpoint: Its address, version included ("http://localhost:8000/v1").
        model: As the server calls it.
        timeout: Seconds to wait for a reply before trying again.

    Raises:
        MissingExtra: The client isn't installed.
    """
    try:
        import openai
    except ImportError as error:
        raise MissingExtra("Asking a model", "models") from error
    key = os.environ.get("OPENAI_API_KEY") or "none"
    client = openai.OpenAI(base_url=endpoint, api_key=key, timeout=timeout, max_retries=RETRIES)

    def ask(images: Sequence[Array], text: str) -> str:
        content: list[Any] = [_part(image) for image in images]
        content.append({"type": "text", "text": text})
        try:
            reply = client.chat.completions.create(
                model=model, messages=[{"role": "user", "content": content}]
            )
        except openai.OpenAIError as error:
            raise ModelFailed(f"{endpoint}: {error}") from error
        words = reply.choices[0].message if reply.choices else None
        if words is None or not words.content:
            refusal = (words and words.refusal) or "the reply is empty"
            raise ModelFailed(f"{model} says nothing: {refusal}")
        return words.content

    return ask


def _part(image: Array) -> dict[str, object]:
    data = base64.b64encode(encode(Image.fromarray(image), "JPEG")).decode()
    return {"type": "image_url", "image_url": {"url": f"data:image/jpeg;base64,{data}"}}
