"""Which words people use for which things, from a file of general English. Knows no catalogue."""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache
from importlib.resources import files

import pydantic
import yaml

from probe.errors import BadData
from probe.files import fault

SAME, KIND, LOOKS, ALIKE = 0.8, 0.7, 0.7, 0.5
"""What a word is worth for a thing that goes by another one: another word for the same, a word
for many such things, a word for its shape or material, a word for something that looks alike."""

ABOVE, LOOSE, SIBLING = 0.6, 0.45, 0.3
"""What a word is worth for a thing that goes by the word for its narrow kind alone ("dog" for an
"animal") or for its wide kind ("hammer" for a "tool"), and for another one of its narrow kind."""


class _Nouns(pydantic.BaseModel, frozen=True, extra="forbid"):
    """The file: groups of words, and words with what they cover."""

    apart: dict[str, str]
    same: list[list[str]]
    alike: list[list[str]]
    contents: dict[str, list[str]]
    kinds: dict[str, list[str]]
    wide: dict[str, list[str]]
    shapes: dict[str, list[str]]
    materials: dict[str, list[str]]
    outlines: dict[str, list[str]]


@lru_cache(1024)
def names_meant(noun: str) -> Mapping[str, float]:
    """Nouns of the things that a person may mean by another noun, and what it is worth for each."""
    known = _nouns()
    found: dict[str, float] = {}
    groups = [(SAME, group) for group in known.same if noun in group]
    groups += [(KIND, group) for group in _members(noun, known.kinds | known.wide)]
    groups += [(ALIKE, group) for group in known.alike if noun in group]
    groups += [(ALIKE, [holder]) for holder, held in known.contents.items() if noun in held]
    groups += [(LOOSE, [kind]) for kind, members in known.wide.items() if noun in members]
    for worth, group in groups:
        for word in group:
            found[word] = max(worth, found.get(word, 0.0))
    found.pop(noun, None)
    return found


@lru_cache(1024)
def kin(noun: str) -> tuple[tuple[str, frozenset[str]], ...]:
    """Narrow kinds that a noun is of, each with its other members."""
    kinds = _nouns().kinds
    return tuple(
        (kind, frozenset(members) - {noun}) for kind, members in kinds.items() if noun in members
    )


@lru_cache(1024)
def looks_meant(word: str) -> Mapping[str, float]:
    """Words of things that a word for a shape or a material fits, and what it is worth for each."""
    known = _nouns()
    fitting = known.shapes.get(word, []) + known.materials.get(word, [])
    return dict.fromkeys(fitting, LOOKS)


@lru_cache(1024)
def outlines_meant(noun: str) -> Mapping[str, float]:
    """Words for the outlines (see `shape_word`) that a part of such a thing may have."""
    return {word: ALIKE for word, nouns in _nouns().outlines.items() if noun in nouns}


def holds(noun: str) -> bool:
    """Whether a noun is that of a package, which people call by what is in it."""
    return noun in _nouns().contents


def is_kind(noun: str) -> bool:
    """Whether a noun is that of a narrow kind."""
    return noun in _nouns().kinds


def apart(word: str) -> list[str]:
    """The words that a word is compared as: two for one that is often written apart."""
    return _nouns().apart.get(word, word).split()


@lru_cache(1)
def vocabulary() -> frozenset[str]:
    """All words for things."""
    known = _nouns()
    covered = (known.contents | known.kinds | known.wide).items()
    groups = [*known.same, *known.alike, *([word, *more] for word, more in covered)]
    return frozenset(word for group in groups for word in group)


def _members(noun: str, kinds: Mapping[str, list[str]]) -> list[list[str]]:
    """What a kind covers, and what the kinds cover that it covers."""
    if noun not in kinds:
        return []
    members = kinds[noun]
    return [members, *(kinds[member] for member in members if member in kinds)]


@lru_cache(1)
def _nouns() -> _Nouns:
    source = files("probe.perception") / "data/nouns.yaml"
    try:
        return _Nouns.model_validate(yaml.safe_load(source.read_text("utf-8")))
    except (yaml.YAMLError, pydantic.ValidationError) as error:
        reason = fault(error, "it") if isinstance(error, pydantic.ValidationError) else str(error)
        raise BadData(str(source), reason, "Correct it") from error
