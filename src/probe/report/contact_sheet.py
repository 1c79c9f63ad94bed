"""Many objects on one sheet, a tile each, drawn by the renderer that draws scenes."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Sequence

from PIL import Image, ImageDraw, ImageFont

from probe.assets.library import Library
from probe.assets.spec import ObjectSpec
from probe.render.portraits import FRONT, GROUND, portrait
from probe.render.renderer import Renderer
from probe.scene.setup import RendererName

TILE_PX = 224
CAPTION_PX = 20
LOADED = 24
"""Objects that the renderer holds at once."""


def one_a_category(specs: Iterable[ObjectSpec]) -> list[ObjectSpec]:
    """The first object of each category, in order."""
    first: dict[str, ObjectSpec] = {}
    for spec in specs:
        first.setdefault(spec.category, spec)
    return list(first.values())


def contact_sheet(
    library: Library,
    specs: Sequence[ObjectSpec],
    *,
    named: bool,
    first: int = 1,
    renderer: RendererName = "filament",
    watch: Callable[[Iterable[ObjectSpec]], Iterable[ObjectSpec]] = iter,
) -> Image.Image:
    """One tile an object in rows, with names beneath if wanted.

    Args:
        library: Has the objects.
        specs: What to draw.
        named: Write names, not numbers alone.
        first: Number of the first.
        renderer: What draws them.
        watch: Goes through the objects as they are drawn, and may show how far that is.

    Raises:
        RenderFailed: The renderer died twice on one of them.
        NoGraphicsDriver: The machine has no Vulkan driver.
        MissingExtra: Blender is to draw and isn't installed.
    """
    columns = max(1, math.ceil(math.sqrt(len(specs) * 1.4)))
    rows = math.ceil(len(specs) / columns)
    height = TILE_PX + CAPTION_PX
    sheet = Image.new("RGB", (columns * TILE_PX, rows * height), (255, 255, 255))
    pen, font = ImageDraw.Draw(sheet), ImageFont.load_default(13)
    tiles = _tiles(library, specs, renderer, watch)
    for k, (spec, tile) in enumerate(zip(specs, tiles, strict=True)):
        x, y = k % columns * TILE_PX, k // columns * height
        sheet.paste(tile, (x, y))
        caption = f"{first + k}  {spec.name}" if named else f"{first + k}"
        pen.text((x + 4, y + TILE_PX + 2), caption, fill=(20, 20, 20), font=font)
    return sheet


def _tiles(
    library: Library,
    specs: Sequence[ObjectSpec],
    engine: RendererName,
    watch: Callable[[Iterable[ObjectSpec]], Iterable[ObjectSpec]],
) -> Iterator[Image.Image]:
    with Renderer(engine=engine) as renderer:
        for number, spec in enumerate(watch(specs)):
            if number % LOADED == 0:
                some = specs[number : number + LOADED]
                renderer.load({it.id: library.body(it.id).mesh for it in some}, GROUND)
            yield Image.fromarray(portrait(renderer, spec.id, spec.size, FRONT, TILE_PX))
