"""A very small, untrained model: Qwen3-VL's architecture, or Llama's for one without pictures.

To see that a recipe works without downloading anything. It knows no language and no pictures.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any, get_args

from probe.files import check_new, whole_folder
from probe.train.dataset.manifest import check_dataset
from probe.train.tune import libraries
from probe.train.tune.tiny_parts import Shape, processor_for, untrained
from probe.transcripts.prompts import Setting, reminder, system_prompt


def make_tiny(dataset: Path, out: Path, shape: Shape) -> int:
    """Write an untrained model with a tokenizer that was trained on a data set's texts.

    Args:
        dataset: That `probe dataset` wrote.
        out: A new folder.
        shape: How small.

    Returns:
        How many weights it has.

    Raises:
        BadData: The data set is broken, or the folder is there already.
        MissingExtra: A library isn't installed.
        OutputFailed: It can't be written.
    """
    check_dataset(dataset)
    check_new(out)
    processor = processor_for(_texts(dataset), shape)
    model = untrained(processor, shape)
    with whole_folder(out) as growing:
        model.save_pretrained(str(growing))
        processor.save_pretrained(str(growing))
    return sum(weights.numel() for weights in model.parameters())


def _texts(dataset: Path) -> Iterator[str]:
    """All words of a data set and what else a model may be told, with the template's breaks."""
    data = libraries.part("datasets")
    for path in sorted((dataset / "data").glob("*.parquet")):
        columns = data.Dataset.from_parquet(str(path)).select_columns(["messages", "tools"])
        for row in columns:
            yield row["tools"]
            for message in row["messages"]:
                yield from ((part["text"] or "") + "\n" for part in message["content"])
                yield from map(_called, message["tool_calls"] or ())
    for setting in get_args(Setting):
        yield system_prompt(setting, "0-1000")
        yield reminder(setting)


def _called(call: dict[str, Any]) -> str:
    named = call["function"]
    return f'{{"name": "{named["name"]}", "arguments": {named["arguments"]}}}\n'
