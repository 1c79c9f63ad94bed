"""What a search came to, in words for the agent. Knows no station and gives out no handles."""

from __future__ import annotations

import json
from collections.abc import Sequence

from probe.perception.things import Thing
from probe.toolshed.graph import thing_lines
from probe.toolshed.refusals import quoted

MOST_OTHERS = 4
"""Other things that a reply lists at most."""

NOTHING_ALIKE = (
    "Nothing that shows in the picture fits this description. It may be hidden by other objects "
    "or not be there at all. Other words, or a place like (512, 300), may help."
)

_NEAREST = (
    "Nothing that shows is called {asked}. Nearest: {listed}. What you mean may be one of these, "
    "be hidden by other objects, or not be there at all."
)

_LIKENESS = "note: nothing that shows is called that; this comes nearest"

Named = tuple[str, Thing]
"""A handle and its thing."""


def found_text(found: Named, others: Sequence[Named], *, literal: bool) -> str:
    """A thing that was found, and others that fit as well, as YAML.

    Args:
        found: The thing.
        others: The others.
        literal: Whether its own words say what was asked for.
    """
    handle, thing = found
    lines = [f"object_id: {handle}", *thing_lines(thing)]
    if not literal:
        lines.append(_LIKENESS)
    if others:
        lines.append("others_that_fit_as_well:")
        lines += [f"- {{{', '.join(_short(*other))}}}" for other in others]
    return "\n".join(lines)


def nearest_text(asked: str, near: Sequence[Named]) -> str:
    """Things that resemble what was asked for, most alike first, or that there are none."""
    if not near:
        return NOTHING_ALIKE
    listed = "; ".join(
        f"{handle}, {thing.words.called}, at {_place(thing)}" for handle, thing in near
    )
    return _NEAREST.format(asked=quoted(asked), listed=listed)


def _short(handle: str, thing: Thing) -> list[str]:
    described = json.dumps(thing.words.called, ensure_ascii=False)
    return [f"object_id: {handle}", f"description: {described}", f"point: {_place(thing)}"]


def _place(thing: Thing) -> str:
    return str(list(thing.point_px))
