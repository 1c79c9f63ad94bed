"""What a training step takes on a processor, by which tokens are compared and how it attends.

Measures internals, not the public API. Some three minutes on two cores.

    .venv/bin/probe unpack-model outputs/base
    .venv/bin/python benchmarks/internals/training_step.py outputs/base

Of one conversation of random tokens, forward and backward in bfloat16 with weights in float32; the
best of some steps, as ratios to the first row.
"""

from __future__ import annotations

from pathlib import Path
from time import perf_counter
from typing import Any

import tyro

from probe.train.tune import libraries
from probe.train.tune.by_blocks import attend_by_blocks
from probe.train.tune.collating import IGNORED
from probe.train.tune.learnt_tokens import learnt_loss
from probe.train.tune.loading import load

FIRST, REPLY, EVERY = 800, 100, 400
"""Tokens before the first reply, of each reply, and from one to the next."""


def batch(tokens: int, words: int) -> dict[str, Any]:
    """A conversation of so many tokens, and which of them are learnt."""
    torch = libraries.torch()
    torch.manual_seed(0)
    ids = torch.randint(0, words, (1, tokens))
    labels = torch.full_like(ids, IGNORED)
    for start in range(FIRST, tokens, EVERY):
        labels[0, start : start + REPLY] = ids[0, start : start + REPLY]
    return {"input_ids": ids, "labels": labels}


def seconds(model: Any, inputs: dict[str, Any], steps: int, *, learnt: bool) -> tuple[float, float]:
    """The best of some steps, and their loss."""
    torch = libraries.torch()
    best, told = float("inf"), float("nan")
    for _ in range(steps):
        model.zero_grad()
        start = perf_counter()
        with torch.autocast("cpu", torch.bfloat16):
            loss: Any = (
                learnt_loss(model, inputs) if learnt else model(**inputs, use_cache=False).loss
            )
        loss.backward()
        best, told = min(best, perf_counter() - start), float(loss)
    return best, told


def main(model: tyro.conf.Positional[Path], tokens: int = 2600, steps: int = 3) -> None:
    """Print a row for each way.

    Args:
        model: A folder.
        tokens: Of the conversation.
        steps: How many are made in each way.
    """
    loaded, _ = load(str(model), exact=True)
    inputs = batch(tokens, loaded.config.vocab_size)
    rows = {"all tokens, PyTorch's kernel": seconds(loaded, inputs, steps, learnt=False)}
    rows["learnt tokens, PyTorch's kernel"] = seconds(loaded, inputs, steps, learnt=True)
    attend_by_blocks(loaded)
    rows["learnt tokens, by blocks"] = seconds(loaded, inputs, steps, learnt=True)
    first = next(iter(rows.values()))[0]
    learnt = int((inputs["labels"] != IGNORED).sum())
    print(
        f"{tokens} tokens, {learnt} of them learnt, {libraries.torch().get_num_threads()} threads"
    )
    for name, (took, loss) in rows.items():
        print(f"{name:33} {took:6.2f} s  {took / first:4.2f}  loss {loss:.4f}")


if __name__ == "__main__":
    tyro.cli(main)
