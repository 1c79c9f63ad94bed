"""`probe assets`: what the object library holds."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import numpy as np
import tyro

from probe.api.resources import Pool, library
from probe.cli.assets_add import add_objects, check_objects
from probe.cli.assets_annotate import annotate, review
from probe.cli.assets_fetch import fetch
from probe.cli.assets_sheet import sheet
from probe.cli.assets_split import split
from probe.cli.categories import of_category
from probe.cli.command_app import CommandApp
from probe.cli.metavars import ObjectId
from probe.cli.screen import Column, ScreenTable, say, sign
from probe.files import write_picture
from probe.render.portraits import AROUND, GROUND, portrait
from probe.render.renderer import Renderer
from probe.scene.setup import RendererName

_SIDE_PX = 400
_WIDTH = 140
"""Signs; so wide is the list where it goes to a file or another program."""

app = CommandApp()
app.command(name="add")(add_objects)
app.command(name="check")(check_objects)
app.command(split)
app.command(fetch)
app.command(sheet)
app.command(annotate)
app.command(review)


@app.command(name="list")
def list_objects(
    pool: Pool = "procedural",
    category: Annotated[str | None, tyro.conf.arg(metavar="CATEGORY")] = None,
) -> None:
    """List the objects of a pool; on a terminal, a page at a time.

    Args:
        pool: Which objects; scans need PROBE_ASSETS.
        category: List the objects of this category only, such as mug or "toy block".
    """
    with sign("Reading the catalogue of objects ..."):
        specs = library(pool).specs
    if category is not None:
        specs = of_category(specs, category)
    words = (Column(it, overflow="fold") for it in ("id", "name", "category", "colours"))
    table = ScreenTable(*words, "kg", Column("size in cm", no_wrap=True))
    for spec in specs:
        size = " x ".join(f"{100 * edge:.1f}" for edge in spec.size)
        colours = ", ".join(spec.colours)
        table.add(spec.id, spec.name, spec.category, colours, f"{spec.mass:.3f}", size)
    table.show_paged(narrowest=_WIDTH)


@app.command
def show(
    object_id: ObjectId,
    pool: Pool = "procedural",
    out: Path = Path("outputs/object.png"),
    renderer: RendererName = "filament",
) -> None:
    """Print what the catalogue knows of an object, and draw it.

    Args:
        object_id: As `probe assets list` prints it.
        pool: Where to look; scans need PROBE_ASSETS.
        out: File for the picture.
        renderer: What draws it; blender needs the extra of that name, and more time.
    """
    with sign(f"Looking for {object_id} ..."):
        objects = library(pool)
        spec, body = objects[object_id], objects.body(object_id)
    facts = ScreenTable(head=False)
    for name, value in vars(spec).items():
        facts.add(name, str(value))
    facts.add("triangles", str(len(body.mesh.faces)))
    facts.add("collision pieces", str(len(body.pieces)))
    facts.show()
    with sign("Drawing ..."), Renderer(engine=renderer) as drawing:
        drawing.load({spec.id: body.mesh}, GROUND)
        views = [portrait(drawing, spec.id, spec.size, side, _SIDE_PX) for side in AROUND]
    write_picture(out, np.concatenate(views, axis=1))
    say(f"Its picture is {out}")
