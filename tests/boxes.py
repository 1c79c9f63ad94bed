"""A table with coloured boxes that is really simulated and rendered."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from tempfile import gettempdir
from typing import Any

from probe.assets.library import Library
from probe.assets.looks import Looks
from probe.assets.mesh.mesh import Body, ConvexPiece
from probe.render.renderer import Renderer
from probe.scene.scene import PlacedObject, Scene
from probe.station.simulated import SimulatedStation
from probe.types import Pose
from probe.world.world import World
from shapes import box, grey_table
from tabletops import spec


@dataclass(frozen=True, eq=False)
class BoxLibrary(Library):
    """Boxes by id."""

    bodies: Mapping[str, Body] = field(default_factory=dict[str, Body])

    def body(self, object_id: str, looks: Looks = 1) -> Body:
        return self.bodies[object_id]

    def form(self, object_id: str) -> Body:
        return self.bodies[object_id]


def box_library(**sizes_and_colours: tuple[float, float, float, int, int, int]) -> BoxLibrary:
    """Boxes by name ("red_box"): size along x, y, z in metres, then sRGB."""
    specs, bodies = [], {}
    for name, (x, y, z, *colour) in sizes_and_colours.items():
        words = name.replace("_", " ")
        entry = replace(spec(words, words.split()[0]), size=(x, y, z), mass=0.1)
        mesh = box(x, y, z, *colour)
        specs.append(entry)
        bodies[entry.id] = Body(mesh, (ConvexPiece(mesh.vertices.astype(float)),))
    # Tables are computed there, and stay for the next process.
    cache = Path(gettempdir()) / "probe-boxes"
    return BoxLibrary(tuple(specs), None, cache, bodies=bodies)


def standing(library: Library, *spots: tuple[str, float, float, float]) -> Scene:
    """A scene of boxes by name, each at x, y and a height of its underside, metres."""
    ids = {entry.name.replace(" ", "_"): entry.id for entry in library.specs}
    placed = [
        PlacedObject(number, ids[name], Pose((x, y, z)))
        for number, (name, x, y, z) in enumerate(spots, start=1)
    ]
    return Scene(987654321, "grey", tuple(placed))


def station_at(scene: Scene, library: Library, renderer: Renderer) -> Any:
    """A fresh simulated station at a scene; the renderer gets its objects."""
    meshes = {placed.object_id: library.body(placed.object_id).mesh for placed in scene.objects}
    renderer.load(meshes, grey_table())
    return SimulatedStation(World(scene, library), renderer)
