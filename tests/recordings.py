"""Reads a recording of Rerun's back, by its own reader."""

from __future__ import annotations

import io
from collections import defaultdict
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

from probe.types import Array


@dataclass(frozen=True)
class Row:
    """What was told of an entity at one moment.

    Attributes:
        step: Number of the call; None where that timeline knows nothing of it.
        time: Simulated seconds; None where that timeline knows nothing of it.
        values: By component ("Points3D:positions").
    """

    step: int | None
    time: float | None
    values: dict[str, Any] = field(compare=False)

    def array(self, name: str) -> Array:
        """A component as an array."""
        return np.array(self.values[name])


def rows_of(path: Path) -> dict[str, list[Row]]:
    """All rows by entity, in the order in which they were told."""
    reader = pytest.importorskip("rerun.chunk").RrdReader(path)
    found: dict[str, list[Row]] = defaultdict(list)
    for chunk in reader.stream():
        batch = chunk.to_record_batch()
        for row in batch.to_pylist():
            time = row.pop("time", None)
            seconds = None if time is None else np.timedelta64(time) / np.timedelta64(1, "s")
            told = {name: value for name, value in row.items() if value is not None}
            found[chunk.entity_path].append(Row(row.pop("step", None), seconds, told))
    return {
        name: sorted(rows, key=lambda row: row.values["rerun.controls.RowId"])
        for name, rows in found.items()
    }


def poses_of(rows: list[Row], timeline: str) -> tuple[Array, Array, Array]:
    """Of a moving entity: moments on a timeline, positions (n, 3), quaternions xyzw (n, 4)."""
    some = [row for row in rows if getattr(row, timeline) is not None]
    moving = [row for row in some if "Transform3D:translation" in row.values]
    return (
        np.array([getattr(row, timeline) for row in moving]),
        np.array([row.values["Transform3D:translation"][0] for row in moving]),
        np.array([row.values["Transform3D:quaternion"][0] for row in moving]),
    )


def picture_of(row: Row) -> Array:
    """An encoded picture, uint8, shape (h, w, 3)."""
    content = bytes(row.values["EncodedImage:blob"][0])
    with Image.open(io.BytesIO(content)) as image:
        return np.asarray(image)
