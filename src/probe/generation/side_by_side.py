"""Who plays where several covers stand side by side, each over something, and where they stand."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from probe.assets.library import Library
from probe.assets.spec import ObjectSpec
from probe.generation.alike import draw_alike, unlike
from probe.generation.covers import GRASP_WIDTH, Cover, Footprint, draw_cover, footprint_of
from probe.generation.likeness import SIDES_TOLERANCE, TWIN_TOLERANCE, Likeness, whole_names_by
from probe.generation.object_selection import (
    CAST_TRIES,
    LARGEST,
    ObjectSelection,
    draw_crowd,
    hideable,
    needs_alike,
    those_to_hide,
)
from probe.generation.result import Rejected
from probe.tasks.options import CANDIDATES
from probe.tasks.task import KIND_RULES, RulesVersion
from probe.types import Array
from probe.world.model import Post

COVERS = 3
"""Covers in a scene, with something beneath each."""

WIDEST = 0.16
"""Longest side on the table in metres of a cover: three of them need room."""

NEEDS_ALIKE = needs_alike(LARGEST, TWIN_TOLERANCE, CANDIDATES + COVERS - 1, sides=True)
"""What lies beneath the covers, for people."""

_FROM_MIDDLE = 0.11


@dataclass(frozen=True, eq=False)
class Hidden:
    """What lies beneath the covers: five candidates for one of them, and what the others hide.

    Attributes:
        candidates: Five.
        secrets: One for each further cover; alike to the candidates, so that nothing tells.
        room: What each of all of them needs.
    """

    candidates: tuple[ObjectSpec, ...]
    secrets: tuple[ObjectSpec, ...]
    room: tuple[Footprint, ...]

    @staticmethod
    def drawn(
        library: Library,
        rng: np.random.Generator,
        rules: RulesVersion,
        secrets: int = COVERS - 1,
    ) -> Hidden:
        """Draw things that are alike in length, width and height.

        Args:
            library: To choose from.
            rng: Draws them.
            rules: By which the task is made.
            secrets: How many are drawn beside the candidates.

        Raises:
            Rejected: The library has too few.
        """
        specs = draw_alike(
            hideable(library),
            library.specs,
            Likeness(TWIN_TOLERANCE, SIDES_TOLERANCE, whole_names=whole_names_by(rules)),
            CANDIDATES + secrets,
            rng,
            varied=rules >= KIND_RULES,
            leads=library.leads,
        )
        room = tuple(footprint_of(library, spec.id) for spec in specs)
        return Hidden(specs[:CANDIDATES], specs[CANDIDATES:], room)


DrawHidden = Callable[[Library, np.random.Generator], Hidden]
"""Draws what is hidden; raises Rejected if there is nothing like it."""

DrawCovers = Callable[[Sequence[ObjectSpec], Hidden], Sequence[Cover]]
"""Draws covers for what is hidden from things that are free: one for each thing, if there are."""


def select(
    library: Library,
    draw: DrawCovers,
    crowd: int,
    rng: np.random.Generator,
    hide: DrawHidden,
) -> ObjectSelection:
    """Who plays, with a crowd of so many.

    Raises:
        Rejected: The library has no such set.
    """
    failure = Rejected("cover", "nothing was drawn")
    for _ in range(CAST_TRIES):
        hidden = hide(library, rng)
        free = unlike(library.specs, [*hidden.candidates, *hidden.secrets])
        covers = draw(free, hidden)
        if len(covers) < (wanted := 1 + len(hidden.secrets)):
            names = ", ".join(spec.name for spec in (*hidden.candidates, *hidden.secrets))
            failure = Rejected("cover", f"only {len(covers)} of {wanted} covers for {names}")
            continue
        try:
            eligible = those_to_hide(library, hidden.candidates, covers)
        except Rejected as rejected:
            failure = rejected
            continue
        others = draw_crowd(unlike(free, [cover.spec for cover in covers]), crowd, rng)
        return ObjectSelection(hidden.candidates, eligible, tuple(covers), others, hidden.secrets)
    raise failure


def draw_unlike_covers(
    library: Library, free: Sequence[ObjectSpec], hidden: Hidden, rng: np.random.Generator
) -> Sequence[Cover]:
    """Covers of several names and looks, which the hand can lift; fewer than COVERS if need be."""
    covers: list[Cover] = []
    for _ in range(COVERS):
        others = unlike(liftable(free), [cover.spec for cover in covers])
        if cover := draw_cover(library, others, hidden.room, rng):
            covers.append(cover)
    return covers


def liftable(specs: Sequence[ObjectSpec]) -> list[ObjectSpec]:
    """Those that the hand can take by their sides, and of which three have room on the table."""
    return [s for s in specs if min(s.size[:2]) <= GRASP_WIDTH and max(s.size) <= WIDEST]


def draw_posts(covers: Sequence[Cover], wider: float, rng: np.random.Generator) -> list[Post]:
    """Places around the middle, further apart than the covers reach.

    Args:
        covers: What goes there.
        wider: How much wider than its cover each disc is that others are kept off.
        rng: Draws how they are turned about the middle.
    """
    angle, apart = float(rng.uniform(0, 2 * math.pi)), 2 * math.sin(math.pi / len(covers))
    reaches = sorted(cover.reach for cover in covers)
    distance = max(_FROM_MIDDLE, wider * (reaches[-1] + reaches[-2]) / apart)
    turns = angle + 2 * math.pi * np.arange(len(covers)) / len(covers)
    places: Array = distance * np.stack([np.cos(turns), np.sin(turns)], axis=1)
    return [
        Post(float(x), float(y), wider * cover.reach)
        for (x, y), cover in zip(places, covers, strict=True)
    ]
