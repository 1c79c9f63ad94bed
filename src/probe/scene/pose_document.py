"""Places and rotations on disk, checked when they are read."""

from __future__ import annotations

import math
from typing import Annotated

import pydantic

from probe.types import Quaternion

FARTHEST = 1e12
"""Metres. Things that are squeezed between others have been seen to fly off for 500 kilometres."""

_ROUNDING = 1e-6


def _unit(wxyz: Quaternion) -> Quaternion:
    if not abs(math.hypot(*wxyz) - 1) <= _ROUNDING:
        raise ValueError(f"a rotation is a quaternion of length 1, not {math.hypot(*wxyz):.6g}")
    return wxyz


_Coordinate = Annotated[float, pydantic.Field(ge=-FARTHEST, le=FARTHEST, allow_inf_nan=False)]
Position = tuple[_Coordinate, _Coordinate, _Coordinate]
"""Metres; near enough to be a place at a table."""

Rotation = Annotated[Quaternion, pydantic.AfterValidator(_unit)]
"""A unit quaternion wxyz."""
