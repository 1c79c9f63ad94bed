"""Fills the templates of pages. Knows nothing of what they show."""

from __future__ import annotations

import base64
import hashlib
import json
from collections.abc import Callable, Mapping, Sequence
from importlib import resources
from pathlib import Path
from typing import Any

import jinja2
from markupsafe import Markup

from probe.files import write_text

_UNSAFE = {ord(sign): f"\\u{ord(sign):04x}" for sign in "<>&\u2028\u2029"}


def write_page(
    path: Path,
    template: str,
    values: Mapping[str, object],
    filters: Mapping[str, Callable[..., object]] | None = None,
) -> None:
    """Fill a template and write the page.

    All text is escaped: words of models and catalogues can't inject HTML.

    Args:
        path: The page.
        template: File in `templates/`.
        values: What the template names.
        filters: Further ways to show values.
    """
    environment = jinja2.Environment(
        loader=jinja2.PackageLoader("probe.report"),
        autoescape=True,
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    for name, shown in (filters or {}).items():
        environment.filters[name] = shown
    write_text(path, environment.get_template(template).render(values))


def script_json(value: Any) -> Markup:
    """A value as JSON that is safe within a script element: no text in it can end the element."""
    return Markup(json.dumps(value, separators=(",", ":")).translate(_UNSAFE))


def joined(folder: str, names: Sequence[str]) -> Markup:
    """Template files of our own, one after the other, as they are: styles or scripts."""
    place = resources.files("probe.report") / "templates" / folder
    return Markup("\n".join((place / name).read_text("utf-8") for name in names))


def digest(text: str) -> str:
    """An inline style or script as a content security policy names it."""
    return "sha256-" + base64.b64encode(hashlib.sha256(text.encode()).digest()).decode()
