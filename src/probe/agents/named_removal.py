"""Lifts what a question names and nothing else, one thing after the other."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from probe.agents.clearing import Search
from probe.agents.reading import Seen
from probe.agents.type_plan import ScriptedQuestion


def gentle_search(asked: ScriptedQuestion) -> Search:
    """A search that pushes nothing, before the first look."""
    return replace(Search.of(asked), first="grasp", gentle=True)


def left_of(search: Search, names: Sequence[str]) -> list[Seen]:
    """Those that are named and still on the table."""
    return [seen for name in names for seen in search.graph.called(name)]


def next_named(search: Search, names: Sequence[str]) -> Seen | None:
    """Which of them to lift next; None if none is left that may be tried."""
    fresh = [seen for seen in left_of(search, names) if search.may_clear(seen)]
    # What lies on top of the others goes first: it would drag them along.
    return min(fresh, key=lambda seen: len(search.graph.over(seen)), default=None)
