"""How many tokens episodes have that are told in the setting text-only, with each form of lists.

Measures internals, not the public API.

    .venv/bin/probe run v1 --limit 30 --out outputs/scripted
    .venv/bin/python benchmarks/internals/text_only.py outputs/scripted tokenizer.json

The second argument is a tokenizer's file, as Hugging Face's `tokenizers` writes it.
"""

from __future__ import annotations

import json
import sys
from dataclasses import replace
from pathlib import Path
from typing import Any, get_args

import numpy as np

from probe.episodes.files import read_records
from probe.episodes.folder import RECORDS
from probe.episodes.record import EpisodeRecord
from probe.transcripts.messages import messages, participation_of
from probe.transcripts.prompts import Graphs, told_with
from probe.transcripts.tools import as_sent

WINDOWS = (2048, 4096, 8192)


def as_text(record: EpisodeRecord, graphs: Graphs) -> str:
    """An episode of an agent without a model as a chat template with Qwen's calls has it."""
    seat = replace(participation_of(record), setting=told_with("text-only", graphs))
    told = messages(replace(record, participation=seat), (), (None,) * len(record.steps))
    rules, *others = told
    tools = json.dumps(as_sent(seat.points, record.scale, "text-only"))
    turns = [f"<|im_start|>system\n{rules.text}\n{tools}<|im_end|>\n"]
    for message in others:
        called = [{"name": call.name, "arguments": call.values} for _, call in message.calls]
        calls = "".join(f"<tool_call>\n{json.dumps(it)}\n</tool_call>" for it in called)
        turns.append(f"<|im_start|>{message.role}\n{message.text}{calls}<|im_end|>\n")
    return "".join(turns)


def main(folder: Path, tokenizer: Path) -> None:
    """Print the median, the 95th percentile and the share that fits each window."""
    import tokenizers  # pyright: ignore[reportMissingImports]  # comes with `make .venv/.torch`

    library: Any = tokenizers
    records = read_records(folder / RECORDS, whole=False)
    counter = library.Tokenizer.from_file(str(tokenizer))
    for graphs in get_args(Graphs):
        tokens = np.array([len(counter.encode(as_text(it, graphs)).ids) for it in records])
        middle, high = np.percentile(tokens, [50, 95])
        fits = ", ".join(f"{np.mean(tokens <= most):.1%} in {most:,}" for most in WINDOWS)
        print(f"{graphs}: {len(tokens)} episodes, median {middle:.0f}, 95 % {high:.0f}, {fits}")


if __name__ == "__main__":
    main(Path(sys.argv[1]), Path(sys.argv[2]))
