"""A page of scenes, to look at."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from probe.report.rendering import write_page


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
    write_page(path, "gallery.html", {"entries": entries})
