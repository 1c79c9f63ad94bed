"""Rows as parquet files that Hugging Face's `datasets` loads; the one place that knows it here."""

from __future__ import annotations

import io
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from probe.errors import MissingExtra
from probe.files import write_bytes
from probe.train.dataset.rows import Row

SHARD_ROWS = 64
"""An episode's pictures take a few megabytes; one file's must fit into memory."""


def table_names(rows: int) -> list[str]:
    """Names of the files that so many rows take."""
    count = max(1, -(-rows // SHARD_ROWS))
    return [f"data/train-{number:05d}-of-{count:05d}.parquet" for number in range(count)]


def write_table(path: Path, rows: Sequence[Row]) -> None:
    """Write one file of a table.

    Raises:
        MissingExtra: The library isn't installed.
        OutputFailed: It can't be written.
    """
    try:
        from datasets import Dataset, disable_progress_bars
    except ImportError as error:
        raise MissingExtra("A data set", "export") from error
    disable_progress_bars()
    buffer = io.BytesIO()
    Dataset.from_list(list(rows), features=_features()).to_parquet(buffer)
    write_bytes(path, buffer.getvalue())


def _features() -> Any:
    from datasets import Features, Image, List, Value

    text = Value("string")
    call = {"id": text, "type": text, "function": {"name": text, "arguments": text}}
    message = {
        "role": text,
        "content": List({"type": text, "text": text}),
        "tool_calls": List(call),
        "tool_call_id": text,
        "weight": Value("int8"),
    }
    columns = dict.fromkeys(("id", "type", "arm", "answer", "augmented"), text)
    return Features({**columns, "messages": List(message), "images": List(Image()), "tools": text})
