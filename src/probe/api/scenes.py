"""Scenes from seeds, and what a camera sees of them."""

from __future__ import annotations

from collections.abc import Generator
from contextlib import contextmanager

from probe.api.resources import tables_for
from probe.assets.library import Library
from probe.render.lighting import light_of
from probe.render.photograph import load_scene
from probe.render.photograph import measure as _measure
from probe.render.photograph import photograph as _photograph
from probe.render.renderer import Renderer
from probe.scene.cameras import View
from probe.scene.lighting import Lighting, lighting_of
from probe.scene.sampling import DEFAULT_COUNT
from probe.scene.scene import Scene
from probe.scene.setup import ROOM_TABLE, RendererName, Setup
from probe.scene.visibility import Visibility
from probe.types import Camera, Frame
from probe.world.scenes import make_scene as _make_scene


def make_scene(
    seed: int,
    library: Library,
    *,
    objects: int = DEFAULT_COUNT,
    table: str | None = None,
    setup: Setup | None = None,
) -> Scene:
    """Drop objects on a table and let physics settle them.

    Args:
        seed: Any whole number from 0; the same seed and library give the same scene.
        library: What the objects are drawn from; see open_library().
        objects: How many.
        table: Id of a table's material; by default one is drawn.
        setup: What stands around the objects; see read_setup(). By default the usual table, in the
            light and with the looks of new scenes.

    Returns:
        The settled table: poses world_from_object in metres, rotations wxyz, the table's top at
        z = 0.

    Raises:
        Unsatisfiable: The objects don't come to rest; another seed or fewer objects may.
    """
    tables = (table,) if table else tables_for("all" if library.assets else "procedural")
    return _make_scene(seed, library, tables, objects, setup=setup or ROOM_TABLE)


def photograph(
    scene: Scene,
    library: Library,
    *,
    camera: Camera | View = "top",
    lighting: Lighting | str | None = None,
    renderer: Renderer | None = None,
) -> Frame:
    """A picture of a scene, with depth and labels.

    Args:
        scene: What stands where.
        library: Has the scene's objects.
        camera: "top" or "front" of the scene's set-up, or a camera of your own.
        lighting: By default that of the scene's set-up. "ambient"; "day_room", that in which
            its table stands, or one of them, "day_room_7"; or the name of other surroundings.
        renderer: One that is running already; by default one is started, and ended afterwards.

    Returns:
        A frame: `rgb` uint8 (h, w, 3), `depth` float32 (h, w) in metres along the optical axis,
        `labels` int32 (h, w) with instance numbers and 0 for the table, and the camera.

    Raises:
        NoGraphicsDriver: The machine has no Vulkan driver.
        UnknownName: No surroundings have this name.
    """
    seen_from = scene.setup.camera(camera) if isinstance(camera, str) else camera
    light = lighting or scene.setup.lighting
    light = lighting_of(light, scene.table) if isinstance(light, str) else light
    with running(renderer, scene.setup.renderer) as drawing:
        load_scene(drawing, scene, library)
        lit = light_of(light, library.assets)
        return _photograph(drawing, scene, camera=seen_from, light=lit)


def visibility(
    scene: Scene,
    library: Library,
    *,
    camera: Camera | View = "top",
    renderer: Renderer | None = None,
) -> dict[int, Visibility]:
    """How much of each object a camera sees.

    Args:
        scene: What stands where.
        library: Has the scene's objects.
        camera: As in photograph().
        renderer: As in photograph().

    Returns:
        By instance number: pixels that are visible, pixels if the object stood there alone, and
        their ratio, `fraction`.

    Raises:
        NoGraphicsDriver: The machine has no Vulkan driver.
    """
    seen_from = scene.setup.camera(camera) if isinstance(camera, str) else camera
    with running(renderer) as drawing:
        load_scene(drawing, scene, library)
        return _measure(drawing, scene, seen_from)


@contextmanager
def running(renderer: Renderer | None, name: RendererName = "filament") -> Generator[Renderer]:
    """The renderer that is given, left running; or a fresh one of a name, ended afterwards."""
    if renderer is not None:
        yield renderer
        return
    with Renderer(engine=name) as fresh:
        yield fresh
