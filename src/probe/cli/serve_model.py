"""`probe serve-model`: a trained model for `probe run` to ask."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import tyro

from probe.cli.numbers import check_numbers
from probe.cli.screen import say
from probe.train.serve.serving import reserved, serve
from probe.train.serve.speaking import MOST_TOKENS, ServedModel


def serve_model(
    model: Annotated[str, tyro.conf.Positional],
    port: int = 8001,
    name: str | None = None,
    cpu_bfloat16: bool = False,
    most_tokens: int = MOST_TOKENS,
    constrained: bool = False,
    temperature: float = 0.0,
    seed: int = 0,
    at_once: int = 1,
) -> None:
    """Serve a model over OpenAI's protocol on this machine, with transformers.

    Without a temperature, it decodes greedily. vLLM does the same many times
    faster where it runs, but samples unless a request says otherwise; see docs/how-to/train.md.

    Args:
        model: A folder that `probe train` wrote, or a name at Hugging Face.
        port: Where to listen.
        name: What the model is called, and must be called in requests; by default its folder's
            name, followed by "-constrained" with that option.
        cpu_bfloat16: Without a GPU, compute in bfloat16 if the processor has instructions for it.
        most_tokens: Of a reply, where a request doesn't say; longer ones are cut off.
        constrained: Rule out all tokens but those that make a call of one of the request's tools,
            with a few words before it.
        temperature: At which replies are drawn where a request doesn't say; at 0 none are.
        seed: Of what is drawn. Replies also depend on the order of the requests.
        at_once: Replies that a language model writes side by side, token by token. A model that
            sees, or whose layers attend to parts of a text, writes one. Replies may differ from
            those written alone, as the last digits of sums do.
    """
    check_numbers(
        {
            "--port": port,
            "--most-tokens": most_tokens,
            "--temperature": temperature,
            "--seed": seed,
            "--at-once": at_once,
        }
    )
    called = name or f"{Path(model).name}{'-constrained' if constrained else ''}"
    with reserved(port) as held:
        speaker = ServedModel(
            model,
            cpu_bfloat16=cpu_bfloat16,
            most_tokens=most_tokens,
            constrained=constrained,
            temperature=temperature,
            seed=seed,
            at_once=at_once,
        )
        say(f"{called} is at http://127.0.0.1:{port}/v1; Ctrl-C stops.")
        serve(speaker, called, held)
