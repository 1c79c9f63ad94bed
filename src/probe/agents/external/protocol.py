"""What is said between us and an agent's process: lines of JSON, each with its bounds.

We speak first. Its process says Confined, then Ready; after that each Step is answered by a Reply.
What comes from there is somebody else's: it is checked, and never anything but data.
"""

from __future__ import annotations

import base64
import io

import numpy as np
import pydantic
from PIL import Image

from probe.episodes.turns import Call, Question, Turn
from probe.files import encode
from probe.toolshed.result import ToolResult
from probe.types import Array, PictureScale

LONGEST = 20_000
"""Characters of a call's arguments, and of the words with it."""

LONGEST_LINE = 6 * 3 * LONGEST
"""Bytes of a line from an agent: JSON may spend six on a character."""


class _Document(pydantic.BaseModel, extra="forbid", allow_inf_nan=False):
    @property
    def line(self) -> bytes:
        return self.model_dump_json().encode() + b"\n"


class Opening(_Document):
    """Our first line: which agent, and what it is allowed.

    Attributes:
        file, name: As in AgentFile.
        seed: For its own draws; it follows from what it is asked and the number of the run.
        memory: Bytes of address space.
        network: Whether it may use the network.
        readable: Files and folders whose content it may read.
        listable: Folders of which it may see the names in them.
        modules: Folders where modules are looked for.
    """

    file: str
    name: str | None
    seed: int
    memory: int
    network: bool
    readable: tuple[str, ...]
    listable: tuple[str, ...]
    modules: tuple[str, ...]


class Confinement(_Document):
    """What the process is kept from: said by our code there, before any of the agent's runs."""

    files: bool
    network: bool
    processes: bool


class AgentReady(_Document):
    """The agent is made.

    Attributes:
        name: Of its class, or of the function that made it.
        pictures: Whether it looks at pictures.
        failed: Why there is no agent, in words.
    """

    name: str = pydantic.Field(default="", max_length=200)
    pictures: bool = False
    failed: str | None = pydantic.Field(default=None, max_length=LONGEST)


class WireQuestion(_Document):
    """A Question; its picture is PNG in base 64."""

    text: str
    options: tuple[tuple[str, str], ...]
    picture: str | None
    scale: PictureScale
    manipulations: int | None

    @staticmethod
    def of(question: Question) -> WireQuestion:
        """The document of a question."""
        return WireQuestion(
            text=question.text,
            options=question.options,
            picture=_written(question.picture),
            scale=question.scale,
            manipulations=question.manipulations,
        )

    def question(self) -> Question:
        """The question it describes."""
        return Question(
            self.text, self.options, _read(self.picture), self.scale, self.manipulations
        )


class WireResult(_Document):
    """A Turn as far as an agent reads it; its picture is PNG in base 64."""

    name: str
    arguments: str
    words: str
    text: str
    picture: str | None

    @staticmethod
    def of(turn: Turn) -> WireResult:
        """The document of a turn."""
        call, result = turn.call, turn.result
        return WireResult(
            name=call.name,
            arguments=call.arguments,
            words=call.words,
            text=result.text,
            picture=_written(result.picture),
        )

    def turn(self) -> Turn:
        """The turn it describes."""
        call = Call(self.name, self.arguments, self.words)
        return Turn(call, ToolResult(self.text, _read(self.picture)))


class AgentTurn(_Document):
    """It is the agent's turn: the question, the first time, and the turns since the last Step."""

    question: WireQuestion | None
    turns: tuple[WireResult, ...]


class WireCall(_Document):
    """A Call."""

    name: str = pydantic.Field(max_length=200)
    arguments: str = pydantic.Field(max_length=LONGEST)
    words: str = pydantic.Field(max_length=LONGEST)


class AgentReply(_Document):
    """What act() gave: a call, or neither for None; or how it failed, in words."""

    call: WireCall | None = None
    failed: str | None = pydantic.Field(default=None, max_length=LONGEST)


def _written(picture: Array | None) -> str | None:
    if picture is None:
        return None
    return base64.b64encode(encode(Image.fromarray(picture), "PNG")).decode()


def _read(picture: str | None) -> Array | None:
    if picture is None:
        return None
    return np.asarray(Image.open(io.BytesIO(base64.b64decode(picture))).convert("RGB"))
