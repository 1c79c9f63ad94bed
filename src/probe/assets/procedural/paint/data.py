"""What all paints and parts share: frozen data from a file, and the paint protocol."""

from __future__ import annotations

from typing import Protocol

import numpy as np
from pydantic import BaseModel, ConfigDict

from probe.assets.procedural.paint.canvas import Canvas
from probe.types import Array


class Data(BaseModel):
    """Frozen data read from a file; unknown keys are errors."""

    model_config = ConfigDict(frozen=True, extra="forbid")


class Paint(Protocol):
    """Anything that can cover a surface."""

    def draw(self, canvas: Canvas, rng: np.random.Generator) -> Array:
        """Picture of the surface, sRGB about 0-1, float32, shape (h, w, 3)."""
        ...
