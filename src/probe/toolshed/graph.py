"""What perception made of a picture, as the YAML that agents read. Knows no truth."""

from __future__ import annotations

import json
from collections.abc import Sequence

from probe.perception.scene_graph import GraphEntry, SceneGraph
from probe.perception.things import Thing
from probe.toolshed.regions import CLEAR, CLUTTERED, regions
from probe.toolshed.relations import EDGE_PX, NEAR_PX, ON_SHARE, STEP, relations
from probe.types import Frame

_INTRODUCTION = """\
# What shows in the picture, from top to bottom. Points and boxes are in pixels: [u, v] and
# [left, top, right, bottom]. """

_IDS = """Numbers belong to this list alone; grasp_and_remove and push take
# an object_id."""

_NO_IDS = """Numbers belong to this list alone. It comes from a model that
# looked at the picture, and holds no object_ids; find_object gives them."""

_RELATIONS = f"""\
# Between neighbours (boxes at most {NEAR_PX} px apart): left_of, right_of, above, below as seen in
# the picture. Where outlines meet over at least {EDGE_PX} px: touching if the heights differ by
# less than {STEP * 1000:.0f} mm; else the higher one is on the other if that is at least
# {ON_SHARE:.0%} of its outline, or covering it if less."""

_REGIONS = f"""\
# Ninths of the picture that are at least {CLUTTERED:.0%} covered, and at most {CLEAR:.0%}."""


_TOLD_RELATIONS = """\
# Between neighbours, as a model judges them from the picture: left_of, right_of, above, below as
# seen in it; touching, on, covering."""

_TOLD_REGIONS = """\
# Ninths of the picture that seem at least half covered, and empty."""


def scene_text(things: Sequence[Thing], handles: Sequence[str], frame: Frame) -> str:
    """Objects, each with its handle, relations and regions as YAML; thresholds as its comments."""
    parts = regions(things, (frame.depth.shape[0], frame.depth.shape[1]))
    graph = SceneGraph(
        tuple(GraphEntry(thing.words, thing.point_px, thing.box_px) for thing in things),
        tuple(relations(things, frame)),
        tuple(parts.cluttered),
        tuple(parts.clear),
    )
    return _graph_text(graph, handles, _RELATIONS, _REGIONS)


def told_text(graph: SceneGraph) -> str:
    """A graph that a model made of the picture, in the same form, without handles."""
    return _graph_text(graph, (), _TOLD_RELATIONS, _TOLD_REGIONS)


def thing_lines(thing: Thing | GraphEntry) -> list[str]:
    """One thing as lines of YAML."""
    told = thing.words.told_name
    name = [f"name: {_text(told)}"] if told is not None else []
    return [
        *name,
        f"description: {_text(thing.words.told_description)}",
        f"point: {list(thing.point_px)}",
        f"box: {list(thing.box_px)}",
    ]


def _graph_text(
    graph: SceneGraph, handles: Sequence[str], on_relations: str, on_regions: str
) -> str:
    introduction = _INTRODUCTION + (_IDS if handles or not graph.entries else _NO_IDS)
    lines = [introduction, "objects:" if graph.entries else "objects: []"]
    for place, entry in enumerate(graph.entries):
        known = [f"object_id: {handles[place]}"] if handles else []
        told = [*known, *thing_lines(entry)]
        lines += [f"- number: {place + 1}", *(f"  {line}" for line in told)]
    lines += [on_relations, "relations:" if graph.relations else "relations: []"]
    lines += [f"- {first + 1} {kind} {second + 1}" for first, kind, second in graph.relations]
    lines += [
        on_regions,
        f"cluttered: {_listed(graph.cluttered)}",
        f"clear: {_listed(graph.clear)}",
    ]
    return "\n".join(lines)


def _text(words: str) -> str:
    return json.dumps(words, ensure_ascii=False)


def _listed(names: Sequence[str]) -> str:
    return f"[{', '.join(names)}]"
