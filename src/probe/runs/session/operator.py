"""The person at the robot: who is told what to do, and asked what they see."""

from __future__ import annotations

from collections.abc import Collection
from typing import Protocol

LAID = "ok"


class Operator(Protocol):
    """All that a session says to a person and hears from one goes through this."""

    def tell(self, *lines: str) -> None:
        """Say some lines."""
        ...

    def ask(self, words: str) -> str:
        """Ask something; returns a line without blanks at its ends, which may be empty."""
        ...


def ask_for(operator: Operator, words: str, wanted: Collection[str]) -> str:
    """Ask until the reply is one of those that are wanted; capitals don't matter."""
    known = {each.casefold(): each for each in wanted}
    while (said := operator.ask(words).casefold()) not in known:
        operator.tell(f"Say {' or '.join(sorted(wanted))}.")
    return known[said]


def ask_in_words(operator: Operator, words: str) -> str:
    """Ask until there is a reply."""
    while not (said := operator.ask(words)):
        operator.tell("A few words are needed.")
    return said
