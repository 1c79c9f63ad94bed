"""How a caller may watch long work; by default nothing is shown."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Protocol, TypeVar

_Item = TypeVar("_Item")


class Track(Protocol):
    """Goes through items and may show how far it is."""

    def __call__(self, items: Iterable[_Item], words: str, /) -> Iterable[_Item]:
        """The same items in the same order; `words` say what is done with them."""
        ...


def silent(items: Iterable[_Item], words: str, /) -> Iterable[_Item]:
    """Shows nothing."""
    return items
