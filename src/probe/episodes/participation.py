"""How a model took part in an episode: what it may do, said and cost. Knows no model.

An agent in a process of its own has one if it failed there: with no setting, and what went wrong.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

Points = Literal["pixels", "0-1000"]
"""How a model counts places in a picture: in pixels, or in thousandths of its width and height."""

_WITHOUT_TOOLS = frozenset({"blind", "rule", "direct", "oracle-view"})


def has_tools(setting: str) -> bool:
    """Whether an episode consists of calls; what follows a comma in a setting's name doesn't count.

    True of all other names: a person's, a program's and a built-in agent's, too.
    """
    return setting.split(",")[0] not in _WITHOUT_TOOLS


def has_pointer(setting: str) -> bool:
    """Whether a model points for perception; a setting's name says so after a comma."""
    return any(part.startswith("pointer ") for part in setting.split(", ")[1:])


@dataclass(frozen=True)
class ModelReply:
    """One reply of a model.

    Attributes:
        calls: How many tools it called; each call is a step of the record.
        words: All that it said, if it called none.
    """

    calls: int
    words: str = ""


@dataclass(frozen=True)
class Participation:
    """A model's part in an episode.

    Attributes:
        setting: How it was allowed to answer.
        points: How it counted places; the record itself always counts pixels.
        replies: All of them, in order.
        tokens_in, tokens_out: Of all its replies; None where its server doesn't say.
        cost: US dollars; None without a price.
        faults: What went wrong between it and us, whether or not it could be mended.
    """

    setting: str
    points: Points = "pixels"
    replies: tuple[ModelReply, ...] = ()
    tokens_in: int | None = None
    tokens_out: int | None = None
    cost: float | None = None
    faults: tuple[str, ...] = ()
