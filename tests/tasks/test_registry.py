"""Question types are folders; one that lacks a part is refused with the part's name."""

from __future__ import annotations

import shutil
import subprocess
import sys
from collections.abc import Generator
from pathlib import Path

import pytest

import probe.question_types
from probe.agents.type_plan import TypePlan
from probe.episodes.evidence import OracleRule
from probe.errors import UnknownName
from probe.generation.observer import Observer
from probe.generation.task_generator import TaskGenerator
from probe.tasks.registry import PARTS, PHRASES, WORDINGS, IncompleteType, part_of, question_types
from probe.tasks.type_rules import TypeRules, rules_of
from probe.verification.type_verifier import Verifier

FOLDER = Path(probe.question_types.__path__[0]) / "beneath"
FILES = (*[f"{part}.py" for part in PARTS], WORDINGS, PHRASES)
"""What a type is made of; one that has all that Beneath has is whole."""

CLASSES = {
    "rules": TypeRules,
    "oracle_view": OracleRule,
    "plan": TypePlan,
    "generator": TaskGenerator,
    "observer": Observer,
    "verifier": Verifier,
}


@pytest.fixture
def seventh(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Generator[Path]:
    """The folder of a seventh type, whole, beside those of the package."""
    folder = tmp_path / "seventh"
    folder.mkdir()
    for name in ("__init__.py", *FILES):
        (folder / name).write_text((FOLDER / name).read_text())
    home = [*probe.question_types.__path__, str(tmp_path)]
    monkeypatch.setattr(probe.question_types, "__path__", home)
    question_types.cache_clear()
    yield folder
    question_types.cache_clear()
    for name in [name for name in sys.modules if name.startswith("probe.question_types.seventh")]:
        del sys.modules[name]


def test_types_come_in_alphabetical_order():
    six = ("beneath", "compare", "count", "find", "reduce", "size")
    assert tuple(name for name in question_types() if name in six) == six
    assert list(question_types()) == sorted(question_types())


def test_beneath_holds_nothing_but_its_parts():
    assert {path.name for path in FOLDER.iterdir()} - {"__pycache__"} == {"__init__.py", *FILES}


@pytest.mark.parametrize("name", question_types())
@pytest.mark.parametrize("part", PARTS)
def test_every_part_of_every_type_is_of_its_class(name: str, part: str):
    assert part_of(name, part, CLASSES[part])


def test_a_whole_seventh_is_found(seventh: Path):
    assert "seventh" in question_types()
    for part, kind in CLASSES.items():
        assert part_of("seventh", part, kind)


@pytest.mark.parametrize("name", FILES)
def test_a_type_that_lacks_a_part_is_refused_with_its_name(seventh: Path, name: str):
    (seventh / name).unlink()
    part = name.removesuffix(".py")
    with pytest.raises(IncompleteType, match=f"'seventh' has no usable part '{part}'"):
        question_types()


def test_a_folder_that_python_cant_import_is_refused_by_name(seventh: Path):
    (seventh / "__init__.py").unlink()
    with pytest.raises(IncompleteType, match="'seventh' has no usable part '__init__.py'"):
        question_types()


def test_folders_that_hold_nothing_of_a_type_are_passed_over(seventh: Path):
    (seventh.parent / "eighth" / "__pycache__").mkdir(parents=True)
    assert "eighth" not in question_types()


@pytest.mark.parametrize("part", PARTS)
def test_a_part_of_another_kind_is_refused(seventh: Path, part: str):
    (seventh / f"{part}.py").write_text(f"{part.upper()} = {{}}\n")
    kind = CLASSES[part]
    with pytest.raises(
        IncompleteType, match=f"it holds no {part.upper()} that is a {kind.__name__}"
    ):
        part_of("seventh", part, kind)


@pytest.mark.parametrize("part", [*PARTS, WORDINGS, PHRASES])
def test_the_package_isnt_imported_while_a_type_lacks_a_part(tmp_path: Path, part: str):
    """In a process of its own, as a contributor would see it."""
    ignore = shutil.ignore_patterns("__pycache__")
    shutil.copytree(Path(probe.__path__[0]), tmp_path / "probe", ignore=ignore)
    types = tmp_path / "probe" / "question_types"
    shutil.copytree(types / "beneath", types / "seventh")
    (types / "seventh" / (part if "." in part else f"{part}.py")).unlink()
    command = [sys.executable, "-c", "import probe.tasks.task"]
    done = subprocess.run(
        command, env={"PYTHONPATH": str(tmp_path)}, capture_output=True, text=True
    )
    assert done.returncode != 0
    assert f"The question type 'seventh' has no usable part '{part}'" in done.stderr


def test_unknown_types_are_refused():
    with pytest.raises(UnknownName, match="beneath"):
        rules_of("eighth")
