"""The objects of a suite on this machine, with signs of life while they are prepared."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from probe.api.resources import everything
from probe.assets.library import Library
from probe.cli.screen import passing, sign
from probe.tasks.suite import Suite, check_objects


def all_objects() -> Library:
    """All objects that are here; see probe.api.resources.everything()."""
    with sign("Reading the catalogue of objects ..."):
        return everything()


def check(suite: Suite, library: Library) -> None:
    """See that objects are those that a suite was made with; shows how far it is.

    Raises:
        BadData: An object is missing or differs.
    """
    check_objects(suite, library, _watched)


def _watched(ids: Iterable[str]) -> Iterator[str]:
    return passing(ids, "Preparing objects, the first time only")
