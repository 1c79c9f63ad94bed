"""A page of scenes, to look at."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import jinja2

from probe.files import write_text


@dataclass(frozen=True)
class GalleryEntry:
    """One scene of a gallery: its files, relative to the page, and what stands on it.

    Attributes:
        objects: Names with their visibility, 0 to 1.
    """

    title: str
    picture: str
    labels: str
    objects: tuple[tuple[str, float], ...]


def write_gallery(path: Path, entries: Sequence[GalleryEntry]) -> None:
    """Write the page; it opens from disk and loads nothing from elsewhere."""
    loader = jinja2.PackageLoader("probe.report")
    page = jinja2.Environment(loader=loader, autoescape=True).get_template("gallery.html")
    write_text(path, page.render(entries=entries))
