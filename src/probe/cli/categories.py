"""Objects of one category, for commands that list or draw them."""

from __future__ import annotations

from collections.abc import Iterable

from probe.assets.spec import ObjectSpec
from probe.errors import UnknownName


def of_category(specs: Iterable[ObjectSpec], category: str) -> list[ObjectSpec]:
    """The objects of a category.

    Raises:
        UnknownName: There are none; nearest categories are named.
    """
    some = tuple(specs)
    known = list(dict.fromkeys(spec.category for spec in some))
    if category not in known:
        raise UnknownName("category", category, known)
    return [spec for spec in some if spec.category == category]
