"""Fills the templates of pages. Knows nothing of what they show."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import jinja2

from probe.files import write_text


def write_page(path: Path, template: str, values: Mapping[str, object]) -> None:
    """Fill a template and write the page.

    All text is escaped: words of models and catalogues can't inject HTML.

    Args:
        path: The page.
        template: File in `templates/`.
        values: What the template names.
    """
    environment = jinja2.Environment(
        loader=jinja2.PackageLoader("probe.report"),
        autoescape=True,
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    write_text(path, environment.get_template(template).render(values))
