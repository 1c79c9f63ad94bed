"""The page beside the table of annotations: each object's pictures and words, and who said them."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import jinja2

from probe.assets.annotation.notes import FIELDS, Note
from probe.files import write_text


def write_review(path: Path, notes: Sequence[Note]) -> None:
    """Write the page; pictures lie in a folder beside it, nothing is loaded from elsewhere."""
    loader = jinja2.PackageLoader("probe.report")
    page = jinja2.Environment(loader=loader, autoescape=True).get_template("review.html")
    write_text(path, page.render(notes=notes, fields=FIELDS))
