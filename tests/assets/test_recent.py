"""A few values in memory."""

from __future__ import annotations

import pytest

from probe.assets.recent import Recent


def test_the_value_not_asked_for_longest_goes() -> None:
    recent, made = Recent[str, str](2), list[str]()

    def ask(key: str) -> str:
        def make() -> str:
            made.append(key)
            return key.upper()

        return recent.get(key, make)

    assert [ask(key) for key in "abacab"] == ["A", "B", "A", "C", "A", "B"]
    assert made == ["a", "b", "c", "b"]


def test_a_dropped_value_is_made_again() -> None:
    recent = Recent[str, int](2)
    assert recent.get("a", lambda: 1) == 1
    recent.drop("a")
    recent.drop("never here")
    assert recent.get("a", lambda: 2) == 2


def test_nothing_is_kept_where_making_fails() -> None:
    recent = Recent[str, int](2)
    with pytest.raises(ZeroDivisionError):
        recent.get("a", lambda: 1 // 0)
    assert recent.get("a", lambda: 3) == 3
