"""What a search came to, in words for the agent. Knows no station and gives out no handles."""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence

from probe.perception.matching import Match
from probe.perception.things import Thing
from probe.toolshed.graph import thing_lines
from probe.toolshed.refusals import quoted

NOTHING_ALIKE = (
    "Nothing that shows in the picture fits this description. It may be hidden by other objects "
    "or not be there at all. Other words, or a place like (512, 300), may help."
)

_NEAREST = (
    "Nothing that shows is called {asked}. Nearest: {listed}. What you mean may be one of these, "
    "be hidden by other objects, or not be there at all."
)

_LIKENESS = "note: nothing that shows is called that; this comes nearest"
_IN_PART = "note: not all of these words fit it"

Named = tuple[str, Thing]
"""A handle and its thing."""


def told_things(match: Match) -> tuple[Thing, ...]:
    """Things that the reply to a search names: the one that was found, then the others."""
    return match.thing, *match.others, *match.maybe


def found_text(match: Match, name: Callable[[Thing], str]) -> str:
    """A thing that was found, others that fit as well, and others that may be meant, as YAML.

    Args:
        match: What was found.
        name: Gives a thing its handle.
    """
    lines = [f"object_id: {name(match.thing)}", *thing_lines(match.thing)]
    if not match.literal:
        lines.append(_LIKENESS)
    elif not match.whole:
        lines.append(_IN_PART)
    lines += _listed("others_that_fit_as_well", match.others, name)
    lines += _listed("others_that_may_be_meant", match.maybe, name)
    return "\n".join(lines)


def nearest_text(asked: str, near: Sequence[Named]) -> str:
    """Things that resemble what was asked for, most alike first, or that there are none."""
    if not near:
        return NOTHING_ALIKE
    listed = "; ".join(
        f"{handle}, {thing.words.called}, at {_place(thing)}" for handle, thing in near
    )
    return _NEAREST.format(asked=quoted(asked), listed=listed)


def _listed(heading: str, things: Sequence[Thing], name: Callable[[Thing], str]) -> list[str]:
    lines = [f"- {{{', '.join(_short(name(thing), thing))}}}" for thing in things]
    return [f"{heading}:", *lines] if lines else []


def _short(handle: str, thing: Thing) -> list[str]:
    described = json.dumps(thing.words.called, ensure_ascii=False)
    return [f"object_id: {handle}", f"description: {described}", f"point: {_place(thing)}"]


def _place(thing: Thing) -> str:
    return str(list(thing.point_px))
