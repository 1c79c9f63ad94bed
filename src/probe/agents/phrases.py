"""What a scripted agent says along with its calls: reasons in words, from a file of phrases."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from importlib.resources import files
from importlib.resources.abc import Traversable

import numpy as np
import pydantic
import yaml

from probe.errors import BadData, UnknownName
from probe.files import fault
from probe.tasks.registry import PHRASES, folder_of, question_types

Say = Callable[[str, Mapping[str, str]], str]
"""Words for an occasion, with what fills their slots."""


@dataclass(frozen=True)
class Reason:
    """Why a thing is moved.

    Attributes:
        reason: Name of the occasion in the phrases.
        other: Name of another thing that has to do with it.
        letter: The mark that has to do with it.
    """

    reason: str
    other: str = ""
    letter: str = ""

    @property
    def slots(self) -> dict[str, str]:
        """What fills a phrase's slots."""
        return {"other": self.other, "letter": self.letter}


def silent(occasion: str, slots: Mapping[str, str]) -> str:
    """Says nothing; a Say."""
    return ""


def plainly(occasion: str, slots: Mapping[str, str]) -> str:
    """Says each thing in one way alone, the first of its phrases; a Say.

    Raises:
        UnknownName: There are none for this occasion.
    """
    return _ways(occasion)[0].format(**slots)


class PhraseBook:
    """Says each thing in one of several ways, as its generator draws; a Say."""

    def __init__(self, rng: np.random.Generator) -> None:
        self._rng = rng

    def __call__(self, occasion: str, slots: Mapping[str, str]) -> str:
        """Words for an occasion.

        Raises:
            UnknownName: There are none for it.
        """
        ways = _ways(occasion)
        return ways[int(self._rng.integers(len(ways)))].format(**slots)


def _ways(occasion: str) -> Sequence[str]:
    known = phrases()
    if occasion not in known:
        raise UnknownName("occasion to say something", occasion, sorted(known))
    return known[occasion]


@lru_cache(1)
def phrases() -> Mapping[str, Sequence[str]]:
    """All phrases, by occasion: those of every question type, and those that each has of its own.

    Raises:
        BadData: A file breaks its schema, or two of them have the same occasion.
    """
    found = _read(files("probe.agents") / "data/phrases.yaml")
    for name in question_types():
        own = _read(folder_of(name) / PHRASES)
        if twice := sorted(set(own) & set(found)):
            raise BadData(f"{name}/{PHRASES}", f"{twice[0]!r} is there already", "Rename it")
        found |= own
    return found


def _read(source: Traversable) -> dict[str, list[str]]:
    try:
        found = yaml.safe_load(source.read_text("utf-8"))
        return pydantic.TypeAdapter(dict[str, list[str]]).validate_python(found)
    except (yaml.YAMLError, pydantic.ValidationError) as error:
        reason = fault(error, "it") if isinstance(error, pydantic.ValidationError) else str(error)
        raise BadData(str(source), reason, "Correct it") from error
