"""`probe assets sheet`: what the library looks like, on one picture."""

from __future__ import annotations

from functools import partial

from probe.api.resources import Pool, library
from probe.cli.categories import of_category
from probe.cli.metavars import File
from probe.cli.screen import passing, say, sign
from probe.files import check_writable, encode, write_bytes
from probe.report.contact_sheet import contact_sheet, one_a_category
from probe.scene.setup import RendererName


def sheet(
    out: File,
    pool: Pool = "procedural",
    named: bool = False,
    category: str | None = None,
    renderer: RendererName = "filament",
) -> None:
    """Draw one object of each category on one sheet.

    Args:
        out: File for the picture (PNG).
        pool: Which objects; scans need PROBE_ASSETS.
        named: Write names below, not numbers alone (which suit asking a stranger).
        category: Draw all objects of this category instead.
        renderer: What draws them; blender needs the extra of that name, and more time.
    """
    with sign("Reading the catalogue of objects ..."):
        objects = library(pool)
    specs = one_a_category(objects.specs)
    if category is not None:
        specs = of_category(objects.specs, category)
    check_writable(out.absolute().parent)
    watch = partial(passing, words="Drawing")
    picture = contact_sheet(objects, specs, named=named, renderer=renderer, watch=watch)
    write_bytes(out, encode(picture, "PNG"))
    say(f"{len(specs)} objects are on {out}")
