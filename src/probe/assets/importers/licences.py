"""SPDX identifiers of licences that data sets state in prose."""

from __future__ import annotations

import re

_WORDS = (
    (r"creative commons attribution 4\.0|cc[ -]by[ -]4\.0|licenses/by/4\.0", "CC-BY-4.0"),
    (r"attribution-sharealike 4\.0|cc[ -]by[ -]sa[ -]4\.0|licenses/by-sa/4\.0", "CC-BY-SA-4.0"),
    (r"cc0|publicdomain/zero/1\.0", "CC0-1.0"),
)


def spdx(text: str) -> str | None:
    """The licence that a text names, or None if it names none that we know."""
    lowered = " ".join(text.lower().split())
    for pattern, identifier in _WORDS:
        if re.search(pattern, lowered):
            return identifier
    return None
