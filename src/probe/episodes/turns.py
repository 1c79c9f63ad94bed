"""What passes between an agent and its tools. Knows no policy and no table."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Protocol

from probe.toolshed.result import ToolResult
from probe.types import USUAL_SCALE, Array, PictureScale


@dataclass(frozen=True)
class Question:
    """What an agent is asked.

    Attributes:
        text: The question.
        options: Letter and text of each option, in order.
        picture: The table at the start, sRGB uint8, shape (h, w, 3); None for agents that
            look at no pictures.
        scale: How much of the table pictures show, as the tools' texts say too.
        manipulations: Grasps and pushes that the question allows, if it says how many; else None.
    """

    text: str
    options: tuple[tuple[str, str], ...]
    picture: Array | None = field(default=None, compare=False, repr=False)
    scale: PictureScale = field(default=USUAL_SCALE, compare=False, repr=False)
    manipulations: int | None = None


@dataclass(frozen=True)
class Call:
    """One call of a tool, as an agent made it.

    Attributes:
        name: Of the tool.
        arguments: Whatever was sent, as JSON text; it needn't fit the tool.
        words: What the agent said or thought along with it.
        values: The arguments as values; the text itself if it isn't JSON.
    """

    name: str
    arguments: str = "{}"
    words: str = ""

    @staticmethod
    def of(name: str, arguments: Mapping[str, Any] | None = None, words: str = "") -> Call:
        """A call with arguments as values."""
        return Call(name, json.dumps(arguments or {}), words)

    @property
    def values(self) -> Any:
        """The arguments as values; the text itself if it isn't JSON."""
        try:
            return json.loads(self.arguments)
        except (ValueError, RecursionError):
            return self.arguments


@dataclass(frozen=True, eq=False)
class Turn:
    """A call and its result.

    Attributes:
        call: What the agent asked a tool to do.
        result: The tool's reply, with `text` and `picture`.
    """

    call: Call
    result: ToolResult


class Agent(Protocol):
    """Decides what to do next from the question and what the tools have told so far."""

    def act(self, question: Question, history: Sequence[Turn]) -> Call | None:
        """The next call; None to end the episode without an answer."""
        ...
