"""What `probe suite verify` does with the salt of a private suite, once that is published."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from probe.errors import BadData
from probe.generation.attempt import Attempt, origins
from probe.generation.salt_file import read_salt
from probe.tasks.suite import Suite


def origins_by(suite: Suite, salt: Path | None, rebuild: int) -> Mapping[str, Attempt] | None:
    """Where a private suite's tasks come from, by id; None without its salt.

    Args:
        suite: Any suite.
        salt: File of its salt, if that is known.
        rebuild: How many of its tasks are to be made again.

    Raises:
        BadData: The salt isn't the suite's, or none is given though it is needed.
    """
    if salt is None:
        if suite.commitment is not None and rebuild:
            reason = f"needs the salt of {suite.name}, a private suite"
            raise BadData("--rebuild", reason, "Say --salt FILE, once it is published")
        return None
    if suite.commitment is None:
        raise BadData("--salt", f"{suite.name} is a public suite", "Leave it out")
    known = read_salt(salt, "Name the salt.json of whoever built the suite")
    if known.commitment != suite.commitment:
        reason = f"isn't the salt that suite {suite.name} is committed to"
        raise BadData(salt, reason, "Ask whoever built the suite for the right one")
    return origins(suite.tasks, known)
