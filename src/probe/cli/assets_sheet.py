"""`probe assets sheet`: what the library looks like, on one picture."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import tyro

from probe.api.resources import Pool, library
from probe.cli.screen import say
from probe.errors import UnknownName
from probe.files import encode, write_bytes
from probe.report.contact_sheet import contact_sheet, one_a_category


def sheet(
    out: Annotated[Path, tyro.conf.Positional],
    pool: Pool = "procedural",
    named: bool = False,
    category: str | None = None,
) -> None:
    """Draw one object of each category on one sheet.

    Args:
        out: File for the picture (PNG).
        pool: Which objects; scans need PROBE_ASSETS.
        named: Write names below, not numbers alone (which suit asking a stranger).
        category: Draw all objects of this category instead.
    """
    objects = library(pool)
    specs = one_a_category(objects.specs)
    if category is not None:
        known = [spec.category for spec in specs]
        if category not in known:
            raise UnknownName("category", category, known)
        specs = [spec for spec in objects.specs if spec.category == category]
    write_bytes(out, encode(contact_sheet(objects, specs, named=named), "PNG"))
    say(f"{len(specs)} objects are on {out}")
