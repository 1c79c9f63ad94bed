"""What was found of one thing that PROBE requires, always or for something."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Requirement:
    """One thing.

    Attributes:
        name: What it is.
        ok: Whether it is here.
        found: What is here, or what exactly is missing.
        use: What needs it.
        remedy: The one command that gets it; empty if nothing has to be done.
        core: Whether nothing works without it.
    """

    name: str
    ok: bool
    found: str
    use: str
    remedy: str = ""
    core: bool = False
