"""Features of the first picture: its scene graph, the visible parts of objects, their colours."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from probe.agents.text_features import Features
from probe.assets.colour.difference import ciede2000
from probe.generation.first_look import FirstLook, VisibleThing
from probe.generation.observer import (
    half_hidden,
    marked,
    misfit,
    named_in,
    says,
    visible_count,
    wanted_colour,
)
from probe.shortcuts.by_catalogue import SIZES
from probe.shortcuts.comparing import is_none, joined, log, number, opposed, relative, with_context
from probe.shortcuts.sample import CatalogueFacts, Sample, known
from probe.tasks.task import PAIR

_FARTHEST = 100.0
_CM2 = 312.0
"""Pixels of a square centimetre of table, so that logarithms of areas are near 0."""


def by_graph(sample: Sample, catalogue: CatalogueFacts) -> tuple[Features, ...]:
    """What is named, what it lies on or touches, and how options go with that."""
    look = sample.look
    if sample.paired:
        a, b = (_neighbours(look, look.marked[letter], catalogue) for letter in PAIR)
        return opposed(sample.form, a, b)
    context = {
        "things": float(len(look.things)),
        "half hidden": float(sum(thing.name is None for thing in look.things)),
        "contacts": float(len(look.contacts)),
        "beside": float(len(half_hidden(sample.question, look))),
    }
    told = with_context(sample.options, context)
    if sample.numbered:
        return joined(told, _beyond(sample, context))
    return joined(told, _kin(sample, catalogue), *_fits(sample, catalogue))


def by_area(sample: Sample, catalogue: CatalogueFacts) -> tuple[Features, ...]:
    """What shows of the marked things; else of all, and of what the question names."""
    look = sample.look
    if sample.paired:
        a, b = (_extent(thing) for thing in marked(look))
        return opposed(sample.form, a, b)
    areas = [thing.area_px for thing in look.things]
    named = [look.things[place] for place in named_in(sample.question, look)]
    context = {
        "covered": sum(areas) / 1024**2,
        "largest": log(max(areas, default=1) / _CM2),
        "named": log(sum(thing.area_px for thing in named) / _CM2) if named else 0.0,
        "beside": log(1 + sum(t.area_px for t in half_hidden(sample.question, look)) / _CM2),
    }
    told = with_context(sample.options, context)
    if sample.numbered:
        return joined(told, _beyond(sample, context))
    # Without anything named, this would be the catalogue's size.
    specs = [catalogue.by_name.get(text) if named else None for text in sample.options]
    room = [spec and SIZES["footprint"](spec) - context["named"] for spec in specs]
    return joined(told, relative("footprint in named", room))


def by_patch(sample: Sample, catalogue: CatalogueFacts) -> tuple[Features, ...]:
    """Colours of the visible parts of the marked objects; else of what is half hidden."""
    look = sample.look
    if sample.paired:
        wanted = None if sample.form == "darker" else wanted_colour(sample.question, look)
        a, b = (
            _patch(thing, wanted)
            | {"said": float(any(says(sample.question, c) for c in thing.colours))}
            for thing in marked(look)
        )
        return opposed(sample.form, a, b)
    beside = half_hidden(sample.question, look)
    anywhere = [thing for thing in look.things if thing.name is None]
    if sample.numbered:
        counted = catalogue.counted(sample.question)
        apart = misfit(" ".join(counted.colours), anywhere) if counted else _FARTHEST
        context = {"misfit": min(apart, _FARTHEST) / _FARTHEST}
        return joined(with_context(sample.options, context), _beyond(sample, context))
    return joined(
        with_context(sample.options, {}),
        relative("misfit beside", _misfits(sample.options, beside)),
        relative("misfit", _misfits(sample.options, anywhere)),
    )


def _misfits(options: Sequence[str], patches: Sequence[VisibleThing]) -> list[float | None]:
    return [
        None if is_none(text) else min(misfit(text, patches), _FARTHEST) / _FARTHEST
        for text in options
    ]


def _neighbours(look: FirstLook, place: int, catalogue: CatalogueFacts) -> dict[str, float]:
    """How a marked thing lies among others, and the catalogue's size of it if it is named."""
    over = [r for r in look.contacts if r.second == place and r.kind != "touching"]
    under = [r for r in look.contacts if r.first == place and r.kind != "touching"]
    spec = catalogue.by_name.get(look.things[place].name or "")
    around = known(catalogue, (look.things[other].name for other in look.meeting(place)))
    return {
        "over it": float(len(over)),
        "under it": float(len(under)),
        "neighbours": float(len(look.meeting(place))),
        "is named": float(spec is not None),
        "longest": 0.0 if spec is None else SIZES["longest"](spec) - log(0.1),
        "longest around": max((SIZES["longest"](o) for o in around), default=log(0.1)) - log(0.1),
    }


def _beyond(sample: Sample, context: Features) -> tuple[Features, ...]:
    """By how much each number exceeds what is seen, alone and with other numbers of the task."""
    seen = visible_count(sample.question, sample.look)
    values = [number(text) for text in sample.options]
    found: list[Features] = []
    for value in values:
        if value is None:
            lacking = {f"none lacks {n}": 1.0 for n in range(3) if seen + n not in values}
            found.append({f"none seen {seen}": 1.0} | lacking)
            continue
        name = f"beyond {value - seen}"
        found.append({name: 1.0} | {f"{name} {key}": x for key, x in context.items()})
    return tuple(found)


def _kin(sample: Sample, catalogue: CatalogueFacts) -> tuple[Features, ...]:
    """How many seen things are the option's, of its category, of its main colour."""
    seen = [thing for thing in sample.look.things if thing.name]
    found: list[Features] = []
    for text in sample.options:
        spec = catalogue.by_name.get(text)
        if spec is None:
            found.append({})
            continue
        found.append(
            {
                "seen": float(sum(thing.name == text for thing in seen)),
                "category seen": float(sum(thing.category == spec.category for thing in seen)),
                "colour seen": float(sum(t.colours[:1] == spec.colours[:1] for t in seen)),
            }
        )
    return tuple(found)


def _fits(sample: Sample, catalogue: CatalogueFacts) -> list[tuple[Features, ...]]:
    """How each option's object compares with the largest that the question names."""
    places = named_in(sample.question, sample.look)
    named = known(catalogue, (sample.look.things[place].name for place in places))
    if not named:
        return []
    cover = max(named, key=lambda spec: max(spec.size))
    specs = [catalogue.by_name.get(text) for text in sample.options]
    ratios = [
        relative(
            f"{name} in cover", [spec and SIZES[name](spec) - SIZES[name](cover) for spec in specs]
        )
        for name in ("longest", "footprint", "height", "mass")
    ]
    alike = [spec and float(spec.colours[:1] == cover.colours[:1]) for spec in specs]
    same = [spec and float(spec.category == cover.category) for spec in specs]
    return [*ratios, relative("cover's colour", alike), relative("cover's category", same)]


def _extent(thing: VisibleThing) -> dict[str, float]:
    left, top, right, bottom = thing.box_px
    box = (right - left + 1) * (bottom - top + 1)
    return {
        "area": log(thing.area_px / _CM2),
        "diagonal": log(float(np.hypot(right - left + 1, bottom - top + 1)) / 100),
        "fill": thing.area_px / box,
        "slender": abs(log((right - left + 1) / (bottom - top + 1))),
        "overlapped": thing.overlapped,
        "bare area": log(thing.area_px / _CM2) * (1 - thing.overlapped),
    }


def _patch(thing: VisibleThing, wanted: np.ndarray | None) -> dict[str, float]:
    colour = np.array(thing.lab)
    lightness, red, yellow = (float(value) / _FARTHEST for value in thing.lab)
    apart = 0.0 if wanted is None else float(ciede2000(colour, wanted)) / _FARTHEST
    chroma = float(np.hypot(red, yellow))
    return {"L": lightness, "a": red, "b": yellow, "chroma": chroma, "misfit": apart}
