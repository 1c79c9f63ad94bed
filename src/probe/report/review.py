"""The page beside the table of annotations: each object's pictures and words, and who said them."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from probe.assets.annotation.notes import FIELDS, Note
from probe.report.rendering import write_page


def write_review(path: Path, notes: Sequence[Note]) -> None:
    """Write the page; pictures lie in a folder beside it, nothing is loaded from elsewhere."""
    drawn = {file.stem for file in (path.parent / "pictures").glob("*.jpg")}
    write_page(path, "review.html", {"notes": notes, "fields": FIELDS, "drawn": drawn})
