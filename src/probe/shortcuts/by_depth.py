"""Features of what a depth camera sees: how high things reach, how steeply they lie."""

from __future__ import annotations

from probe.agents.text_features import Features
from probe.generation.first_look import FirstLook, VisibleThing
from probe.generation.observer import marked, named_in
from probe.shortcuts.comparing import joined, log, opposed, relative, with_context
from probe.shortcuts.sample import CatalogueFacts, Sample
from probe.tasks.task import PAIR

_TYPICAL = 0.03
"""Metres, so that logarithms of heights are near 0."""


def by_depth(sample: Sample, catalogue: CatalogueFacts) -> tuple[Features, ...]:
    """Height and tilt of marked things and of what lies on them; else of what the question names.

    Options are compared with the height at which the lowest named thing lies.
    """
    look = sample.look
    if sample.paired:
        a, b = (
            _relief("", thing) | _relief("cover's ", cover_of(look, look.marked[letter]))
            for letter, thing in zip(PAIR, marked(look), strict=True)
        )
        return opposed(sample.form, a, b)
    named = [look.things[place] for place in named_in(sample.question, look)]
    highest = max(named or look.things, key=lambda thing: thing.top_m, default=None)
    told = with_context(sample.options, _relief("", highest))
    gaps = height_gaps(sample, catalogue)
    return joined(told, *(relative(f"{name} off", values) for name, values in gaps.items()))


def cover_of(look: FirstLook, place: int) -> VisibleThing | None:
    """The highest of what lies on a thing or covers it; None if nothing does."""
    over = [look.things[r.first] for r in look.contacts if r.second == place and _is_over(r.kind)]
    return max(over, key=lambda thing: thing.top_m, default=None)


def height_gaps(sample: Sample, catalogue: CatalogueFacts) -> dict[str, list[float | None]]:
    """How far each option's object is from filling the room beneath what the question names.

    Returns:
        Logarithms of ratios, without sign, of its height and of its shortest side; empty where
        nothing that is named can be seen.
    """
    room = room_beneath(sample, catalogue)
    if room is None:
        return {}
    specs = [catalogue.by_name.get(text) for text in sample.options]
    heights = [spec and abs(log(spec.size[2]) - log(room)) for spec in specs]
    shortest = [spec and abs(log(min(spec.size)) - log(room)) for spec in specs]
    return {"height": heights, "shortest side": shortest}


def room_beneath(sample: Sample, catalogue: CatalogueFacts) -> float | None:
    """How high the lowest thing that is named lies above the table, metres, if it is flat."""
    things = [sample.look.things[place] for place in named_in(sample.question, sample.look)]
    rooms = [
        thing.top_m - min(spec.size)
        for thing in things
        if (spec := catalogue.by_name.get(thing.name or ""))
    ]
    return max(min(rooms), 0.001) if rooms else None


def _is_over(kind: str) -> bool:
    return kind != "touching"


def _relief(of: str, thing: VisibleThing | None) -> dict[str, float]:
    if thing is None:
        return {f"{of}height": 0.0, f"{of}tilt": 0.0}
    return {f"{of}height": log(thing.top_m / _TYPICAL), f"{of}tilt": thing.tilt}
