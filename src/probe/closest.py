"""Names that somebody may have meant who typed another one. Pure."""

from __future__ import annotations

import re
from collections.abc import Sequence
from difflib import SequenceMatcher

_MOST = 3
_ALIKE = 0.6
"""Least similarity of two names; the measure and its usual bound are difflib's."""


def closest(name: str, known: Sequence[str]) -> list[str]:
    """Up to three known names, the likeliest first; none if nothing comes near.

    A name counts as near if it holds all words of the one that was typed ("red_block" in
    "proc_red_block"), or if it is spelt alike.
    """
    typed = _words(name)
    scored = [(_likeness(name, typed, each), each) for each in known if each]
    near = [(score, each) for score, each in scored if score >= _ALIKE]
    near.sort(key=lambda pair: -pair[0])
    return [each for _, each in near[:_MOST]]


def did_you_mean(name: str, known: Sequence[str]) -> str:
    """A question that names the closest ones: "Did you mean v1 or v1.1?"; empty without any."""
    near = closest(name, known)
    return f"Did you mean {' or '.join(near)}?" if near else ""


def _likeness(name: str, typed: set[str], other: str) -> float:
    spelt = SequenceMatcher(None, name.lower(), other.lower()).ratio()
    # Shorter names that hold every word come before longer ones, and before mere likeness.
    return 1 + spelt if typed and typed <= _words(other) else spelt


def _words(name: str) -> set[str]:
    return set(re.findall(r"[a-z0-9]+", name.lower()))
