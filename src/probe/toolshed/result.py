"""What a tool call hands back. Plain values."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from probe.types import Array

Status = Literal["done", "failed", "malformed", "refused"]

DID_NOTHING = frozenset[Status]({"malformed", "refused"})
"""How a call went that cost its turn and no more."""

MOVING = ("grasp_and_remove", "push")
"""Tools that move something."""

LAST_TURN = "This was the last turn; the episode has ended."
"""The last line of the last reply, if there is no answer by then."""


@dataclass(frozen=True, eq=False)
class ToolResult:
    """The outcome of one call.

    Attributes:
        text: What the agent reads.
        picture: What it sees, sRGB uint8, shape (h, w, 3); None where there is nothing new, or
            where nobody looks at pictures.
        ended: Whether the episode is over.
        status: For statistics; agents get the text alone. "failed" is a manipulation or a search
            that didn't work out, "malformed" and "refused" did nothing.
        point_px: (u, v) of what the call was about, if it was about one thing.
    """

    text: str
    picture: Array | None = None
    ended: bool = False
    status: Status = "done"
    point_px: tuple[int, int] | None = None


@dataclass(frozen=True)
class Answer:
    """A final answer: the option's letter, and (u, v) in pixels if a point was given."""

    choice: str
    point_px: tuple[float, float] | None = None
