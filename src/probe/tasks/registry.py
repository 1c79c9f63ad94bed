"""Which question types there are, and where the parts of each lie. Knows none of them by name.

A question type is a folder of `probe.question_types`. Each of its parts is a module there, named
after the part, that holds one value: `beneath/rules.py` holds `RULES`. Who needs a part asks for it
here, by name, and says which class it must be of. So a folder holds all of a type, and still nobody
imports what lies above it: tasks ask for rules alone, which know no tools (decision 26).
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from pkgutil import iter_modules
from typing import TypeVar

from probe.errors import ProbeError, UnknownName

_PACKAGE = "probe.question_types"

PARTS = ("rules", "oracle_view", "plan", "generator", "observer", "verifier")
"""The modules that every question type has, each known to the layer that asks for it."""

WORDINGS, PHRASES = "wordings.yaml", "phrases.yaml"
FILES = (WORDINGS, PHRASES)
"""The files that every question type has: ways to ask, and what a scripted agent says of it."""

_Part = TypeVar("_Part")


class IncompleteType(ProbeError):
    """A question type lacks a part."""

    def __init__(self, name: str, part: str, reason: str) -> None:
        super().__init__(
            f"The question type {name!r} has no usable part {part!r}: {reason}. "
            "docs/how-to/extend/add-a-task.md lists the parts that a type has."
        )
        self.part = part


@lru_cache
def question_types() -> tuple[str, ...]:
    """Names of all question types, in alphabetical order.

    Raises:
        IncompleteType: One of them lacks a part; the message names both.
    """
    packages = {found.name for found in iter_modules(_folders()) if found.ispkg}
    names = sorted(packages | _begun())
    for name in names:
        _check(name)
    return tuple(names)


def part_of(name: str, part: str, kind: type[_Part]) -> _Part:
    """A part of a question type.

    Args:
        name: Of the type.
        part: One of PARTS.
        kind: What the part must be.

    Raises:
        UnknownName: There is no such type.
        IncompleteType: The part isn't there, or isn't what it must be.
    """
    if name not in question_types():
        raise UnknownName("question type", name, list(question_types()))
    module = import_module(f"{_PACKAGE}.{name}.{part}")
    found = getattr(module, part.upper(), None)
    if not isinstance(found, kind):
        raise IncompleteType(name, part, f"it holds no {part.upper()} that is a {kind.__name__}")
    return found


def folder_of(name: str) -> Path:
    """Where a question type lies.

    Raises:
        UnknownName: There is no such type.
    """
    if name not in question_types():
        raise UnknownName("question type", name, list(question_types()))
    return next(Path(home) / name for home in _folders() if (Path(home) / name).is_dir())


def _begun() -> set[str]:
    """Names of the folders that hold anything of a type, whether Python can import them or not."""
    expected = {*[f"{part}.py" for part in PARTS], *FILES}
    folders = [each for home in _folders() for each in Path(home).iterdir() if each.is_dir()]
    return {each.name for each in folders if any((each / file).is_file() for file in expected)}


def _check(name: str) -> None:
    if not any((Path(home) / name / "__init__.py").is_file() for home in _folders()):
        raise IncompleteType(name, "__init__.py", "the file isn't in its folder")
    for part in PARTS:
        if find_spec(f"{_PACKAGE}.{name}.{part}") is None:
            raise IncompleteType(name, part, f"there is no {part}.py in its folder")
    for file in FILES:
        if not any((Path(home) / name / file).is_file() for home in _folders()):
            raise IncompleteType(name, file, "the file isn't in its folder")


def _folders() -> Sequence[str]:
    return list(import_module(_PACKAGE).__path__)
