"""How many tokens a second a language model writes, alone and with several replies side by side.

Measures internals, not the public API. Some five minutes on two cores.

    .venv/bin/probe unpack-model outputs/base
    .venv/bin/python benchmarks/internals/serving.py outputs/base --cpu-bfloat16

As many conversations as there are at most at once, each of random tokens, get a reply of so many
tokens; the time for reading them isn't counted. The first row is transformers' generate(), one
conversation after the other.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from time import perf_counter
from typing import Any

import tyro

from probe.train.serve.choosing import Chooser
from probe.train.serve.next_token import attend_to_next
from probe.train.serve.writing import Writer
from probe.train.tune import libraries
from probe.train.tune.by_blocks import attend_by_blocks
from probe.train.tune.loading import load


def seconds(write: Callable[[list[int], int], Any], texts: Sequence[list[int]], most: int) -> float:
    """For a reply to each of one half, without reading: replies of one token to the other half."""
    took, half = list[float](), len(texts) // 2
    write(texts[0][::-1], 1)  # the first time takes longer
    for some, tokens in ((texts[:half], 1), (texts[half:], most)):
        start = perf_counter()
        with ThreadPoolExecutor(half) as pool:
            list(pool.map(write, some, [tokens] * half))
        took.append(perf_counter() - start)
    return took[1] - took[0]


def written_by(model: Any, at_once: int) -> Callable[[list[int], int], Any]:
    """What writes a reply of so many tokens, some side by side."""
    writer, chooser = Writer(model, at_once, frozenset()), Chooser(model.generation_config, 0.0)
    return lambda text, most: writer.write(text, most, chooser)


def main(
    model: tyro.conf.Positional[Path],
    cpu_bfloat16: bool = False,
    tokens: int = 2000,
    most: int = 40,
    at_once: tuple[int, ...] = (1, 2, 4, 8),
) -> None:
    """Print a row for each number of replies at once.

    Args:
        model: A folder.
        cpu_bfloat16: Without a GPU, compute in bfloat16 if the processor has instructions for it.
        tokens: Of a conversation.
        most: Of a reply.
        at_once: Replies.
    """
    torch = libraries.torch()
    loaded, _ = load(str(model), cpu_bfloat16=cpu_bfloat16)
    loaded.eval()
    torch.manual_seed(0)
    texts = torch.randint(0, loaded.config.vocab_size, (2 * max(at_once), tokens)).tolist()

    def generate(text: list[int], length: int) -> None:
        how: dict[str, Any] = {"min_new_tokens": length, "max_new_tokens": length}
        with torch.inference_mode():
            loaded.generate(torch.tensor([text]), do_sample=False, **how)

    took = {"generate()": seconds(generate, texts[:2], most) * max(at_once)}
    if loaded.dtype == torch.bfloat16:
        attend_by_blocks(loaded)
    attend_to_next(loaded)
    for number in at_once:
        took[f"at once: {number}"] = seconds(written_by(loaded, number), texts, most)
    first, written = next(iter(took.values())), max(at_once) * (most - 1)
    print(f"{written} tokens, each after about {tokens}, {torch.get_num_threads()} threads")
    for name, each in took.items():
        print(f"{name:12} {written / each:6.1f} tokens/s  {first / each:5.2f}")


if __name__ == "__main__":
    tyro.cli(main)
