"""`probe serve-model`: a trained model for `probe run` to ask."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import tyro

from probe.cli.numbers import check_numbers
from probe.cli.screen import say
from probe.train.serve.serving import reserved, serve
from probe.train.serve.speaking import ServedModel


def serve_model(
    model: Annotated[str, tyro.conf.Positional], port: int = 8001, name: str | None = None
) -> None:
    """Serve a model over OpenAI's protocol on this machine, one reply at a time, with transformers.

    Without a temperature in the request, it decodes greedily. vLLM does the same many times
    faster where it runs, but samples unless a request says otherwise; see docs/how-to/train.md.

    Args:
        model: A folder that `probe train` wrote, or a name at Hugging Face.
        port: Where to listen.
        name: What the model is called, and must be called in requests; by default its folder's
            name.
    """
    check_numbers({"--port": port})
    called = name or Path(model).name
    with reserved(port) as held:
        speaker = ServedModel(model)
        say(f"{called} is at http://127.0.0.1:{port}/v1; Ctrl-C stops.")
        serve(speaker, called, held)
