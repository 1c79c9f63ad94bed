"""What people may call themselves, and what a file of theirs is called. Knows no folder."""

from __future__ import annotations

import hashlib
import unicodedata

from probe.errors import ProbeError

LONGEST = 40
"""Characters."""


class BadName(ProbeError):
    """A name that can't stand in a table of scores."""

    def __init__(self) -> None:
        super().__init__(
            f"Give a name of 1 to {LONGEST} characters in one line, without control characters."
        )


def name_of(said: str) -> str:
    """A name as it is kept: composed, with single spaces.

    Raises:
        BadName: It is empty, too long, or holds what doesn't print.
    """
    if not all(sign.isprintable() or sign in "\t\n" for sign in said):
        raise BadName
    name = unicodedata.normalize("NFC", " ".join(said.split()))
    if not 0 < len(name) <= LONGEST:
        raise BadName
    return name


def file_of(name: str) -> str:
    """Name of a person's own file; it says nothing and is safe on any disk."""
    return hashlib.sha256(name.encode()).hexdigest()[:16] + ".jsonl"
