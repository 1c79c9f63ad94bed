"""Question types are folders; one that lacks a part is refused with the part's name."""

from __future__ import annotations

import sys
from collections.abc import Generator
from pathlib import Path

import pytest

import probe.question_types
from probe.errors import UnknownName
from probe.tasks.registry import PARTS, WORDINGS, IncompleteType, part_of, question_types
from probe.tasks.type_rules import TypeRules, rules_of

RULES = """
from probe.tasks.type_rules import TypeRules

RULES = TypeRules(forms={"plain": frozenset()}, answers="objects", fewest_targets=1)
"""
FILES = {"rules.py": RULES, WORDINGS: "question_type: seventh\nforms:\n  plain: []\n"}


@pytest.fixture
def seventh(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Generator[Path]:
    """The folder of a seventh type, whole, beside those of the package."""
    folder = tmp_path / "seventh"
    folder.mkdir()
    for name, text in {"__init__.py": "", **FILES}.items():
        (folder / name).write_text(text)
    home = [*probe.question_types.__path__, str(tmp_path)]
    monkeypatch.setattr(probe.question_types, "__path__", home)
    question_types.cache_clear()
    yield folder
    question_types.cache_clear()
    for name in [name for name in sys.modules if name.startswith("probe.question_types.seventh")]:
        del sys.modules[name]


def test_there_are_six_in_alphabetical_order():
    assert question_types() == ("beneath", "compare", "count", "find", "reduce", "size")


def test_every_file_of_the_test_is_a_part():
    assert {f"{part}.py" for part in PARTS} | {WORDINGS} == set(FILES)


def test_a_whole_seventh_is_found(seventh: Path):
    assert "seventh" in question_types()
    assert rules_of("seventh").answers == "objects"


@pytest.mark.parametrize("name", FILES)
def test_a_type_that_lacks_a_part_is_refused_with_its_name(seventh: Path, name: str):
    (seventh / name).unlink()
    part = name.removesuffix(".py")
    with pytest.raises(IncompleteType, match=f"'seventh' has no usable part '{part}'"):
        question_types()


def test_a_part_of_another_kind_is_refused(seventh: Path):
    (seventh / "rules.py").write_text("RULES = {}\n")
    with pytest.raises(IncompleteType, match="it holds no RULES that is a TypeRules"):
        part_of("seventh", "rules", TypeRules)


def test_unknown_types_are_refused():
    with pytest.raises(UnknownName, match="beneath"):
        rules_of("eighth")
