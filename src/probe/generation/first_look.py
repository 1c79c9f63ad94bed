"""What the first picture shows, as plain values: all that somebody has who only looks. No truth."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from scipy import ndimage

from probe.assets.library import Library
from probe.assets.spec import ObjectSpec
from probe.generation.palettes import shades
from probe.perception.oracle import Oracle
from probe.perception.outline import window_of
from probe.perception.scene_graph import Contact, Relation
from probe.perception.things import Thing
from probe.render.lighting import light_of
from probe.render.photograph import labels_of, load_scene, measure, photograph
from probe.render.renderer import Renderer
from probe.tasks.task import Letter, Mark, Task
from probe.toolshed.relations import STEP, relations
from probe.types import Array, Frame

CONTACTS: tuple[Contact, ...] = "on", "covering", "touching"

_RING_PX = 4


@dataclass(frozen=True)
class VisibleThing:
    """One thing that shows.

    Attributes:
        name, category: None and empty where too little shows to be named.
        colours: Words for its main colours, largest first.
        area_px: Pixels that show.
        box_px: First and last column and row: left, top, right, bottom.
        lab: Main colour of what shows, CIELAB.
        overlapped: Share of its outline along which something higher adjoins, 0 to 1.
        top_m: Height above the table of the highest point that shows, metres.
        tilt: Angle between the vertical and the plane that fits best what shows, radians.
    """

    name: str | None
    category: str
    colours: tuple[str, ...]
    area_px: int
    box_px: tuple[int, int, int, int]
    lab: tuple[float, float, float]
    overlapped: float
    top_m: float
    tilt: float


@dataclass(frozen=True)
class FirstLook:
    """What shows at the start.

    Attributes:
        things: By point from top to bottom, then left to right, as perceive_scene lists them.
        contacts: Which of them lie on, cover or touch each other; places in `things`.
        marked: Places in `things` of what lies at the marks, by letter; empty without marks.
    """

    things: tuple[VisibleThing, ...]
    contacts: tuple[Relation, ...]
    marked: Mapping[Letter, int]

    def called(self, name: str) -> tuple[VisibleThing, ...]:
        """All that go by this name."""
        return tuple(thing for thing in self.things if thing.name == name)

    def meeting(self, place: int) -> tuple[int, ...]:
        """Places of all that lie on, cover or touch a thing, or the other way round."""
        return tuple(
            other
            for one, _, two in self.contacts
            for mine, other in ((one, two), (two, one))
            if mine == place
        )


def look_at(task: Task, library: Library, renderer: Renderer) -> FirstLook:
    """Look at a task's table as an agent's first picture shows it; replaces what was loaded."""
    load_scene(renderer, task.scene, library)
    camera = task.viewpoint.camera
    seen = measure(renderer, task.scene, camera)
    shares = {number: each.fraction for number, each in seen.items()}
    light = light_of(task.viewpoint.lighting, library.assets)
    frame = replace(photograph(renderer, task.scene, camera=camera, light=light), shares=shares)
    words = {placed.instance: library[placed.object_id] for placed in task.scene.objects}
    return first_look(frame, words, task.marks)


def visible_areas(task: Task, library: Library, renderer: Renderer) -> dict[str, int]:
    """Pixels that show of the thing at each mark; replaces what was loaded."""
    load_scene(renderer, task.scene, library)
    labels = labels_of(renderer, task.scene, task.viewpoint.camera)
    spots = {mark.letter: labels[mark.point[::-1]] for mark in task.marks}
    return {letter: int(np.count_nonzero(labels == spot)) for letter, spot in spots.items()}


def first_look(
    frame: Frame, words: Mapping[int, ObjectSpec], marks: Sequence[Mark] = ()
) -> FirstLook:
    """What a frame shows.

    Args:
        frame: Of a simulated table, with colours, labels and shares.
        words: What the catalogue says of each object; only what counts as seen is named.
        marks: Drawn on the picture.
    """
    things = Oracle(words).detect(frame)
    found = relations(things, frame)
    return FirstLook(
        tuple(_sight(thing, frame) for thing in things),
        tuple(relation for relation in found if relation.kind in CONTACTS),
        {mark.letter: _at(things, mark.point) for mark in marks},
    )


def _at(things: Sequence[Thing], point: tuple[int, int]) -> int:
    """Place of the thing at a pixel; marks lie on something that shows."""
    u, v = point
    return next(place for place, thing in enumerate(things) if thing.mask[v, u])


def _sight(thing: Thing, frame: Frame) -> VisibleThing:
    assert frame.rgb is not None
    return VisibleThing(
        thing.words.name,
        thing.words.category,
        thing.words.colours,
        int(np.count_nonzero(thing.mask)),
        thing.box_px,
        shades(frame.rgb[thing.mask])[0].lab,
        _overlapped(thing.mask, frame),
        *_relief(thing.mask, frame),
    )


def _relief(mask: Array, frame: Frame) -> tuple[float, float]:
    """Greatest height of what a mask shows, metres, and its tilt, radians; see VisibleThing."""
    rows, columns = np.nonzero(mask)
    uv = np.column_stack([columns, rows]) + 0.5
    points = frame.camera.lift(uv, frame.depth[mask])
    flat = np.column_stack([points[:, :2] - points[:, :2].mean(axis=0), np.ones(len(points))])
    (along_x, along_y, _), *_ = np.linalg.lstsq(flat, points[:, 2])
    return float(points[:, 2].max()), float(np.arctan(np.hypot(along_x, along_y)))


def _overlapped(mask: Array, frame: Frame) -> float:
    """Share of the pixels just outside a mask that lie higher than the mask's nearest."""
    window = window_of(mask, _RING_PX)
    mask, depth = mask[window], frame.depth[window]
    distances, nearest = ndimage.distance_transform_edt(~mask, return_indices=True)
    ring = (distances > _RING_PX - 1) & (distances <= _RING_PX)
    rise = depth[nearest[0][ring], nearest[1][ring]] - depth[ring]
    return float((rise > STEP).mean()) if len(rise) else 0.0
