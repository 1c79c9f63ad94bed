"""Why a call did nothing, in words that an agent can act on; each costs the turn and no more."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Literal

from probe.errors import ProbeError

SHOWN = 60
"""Characters of an agent's own words that a message repeats at most."""


class Refusal(ProbeError):
    """A call that did nothing."""

    status: Literal["malformed", "refused"] = "malformed"


class UnknownTool(Refusal):
    """There is no tool of this name."""

    def __init__(self, name: object, known: Sequence[str]) -> None:
        super().__init__(f"There is no tool called {quoted(name)}. Tools: {', '.join(known)}.")


class BadArguments(Refusal):
    """The arguments aren't what the tool takes."""

    def __init__(self, tool: str, problems: Sequence[str], usage: str) -> None:
        super().__init__(f"{tool} did nothing: {'; '.join(problems)}. Call it like {usage}.")


class UnknownHandle(Refusal):
    """No tool gave out this id."""

    def __init__(self, name: str, known: Sequence[str]) -> None:
        so_far = (
            f"So far there are {len(known)}, up to {known[-1]}" if known else "There are none yet"
        )
        super().__init__(
            f"There is no object_id {quoted(name)}. An object_id comes from perceive_scene or "
            f"find_object. {so_far}."
        )


class StaleHandle(Refusal):
    """What the id pointed at no longer looks as it did."""

    def __init__(self, name: str) -> None:
        super().__init__(
            f"{name} is out of date: that place in the picture has changed since it was "
            "given out. Call perceive_scene or find_object for a new object_id."
        )


class BudgetSpent(Refusal):
    """No manipulation is left."""

    status = "refused"

    def __init__(self, budget: int) -> None:
        super().__init__(
            f"Nothing was moved: all {budget} manipulations are used up. You can still call "
            "perceive_scene, find_object and answer_question."
        )


class NoSuchOption(Refusal):
    """The question doesn't offer the letter of an answer."""

    def __init__(self, choice: str, letters: Sequence[str]) -> None:
        offered = f"{', '.join(letters[:-1])} and {letters[-1]}"
        super().__init__(
            f"Nothing is recorded: this question has no option {choice}. Its options are "
            f"{offered}. Answer with one of these letters."
        )


class PointMissing(Refusal):
    """The question asks for a point, and the answer has none; said once in an episode."""

    def __init__(self) -> None:
        super().__init__(
            "This question asks you to point at something: give point=[u, v] as well, a place on "
            "that object in the last picture you were shown. Nothing is recorded yet. If you "
            "can't give a point, answer again without one; that answer is then recorded."
        )


class EpisodeOver(Refusal):
    """A call after the end."""

    status = "refused"

    def __init__(self) -> None:
        super().__init__("The episode has ended; no further call does anything.")


def quoted(said: object) -> str:
    """An agent's own word as it may be repeated: one line of ASCII, cut short."""
    if not isinstance(said, str):
        return f"a {type(said).__name__}"
    whole = ascii(said[: SHOWN + 1])
    return whole if len(said) <= SHOWN else ascii(said[:SHOWN]) + "..."
