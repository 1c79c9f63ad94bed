"""Which objects commands take by default, and that they say it if they take others."""

from __future__ import annotations

import inspect
import json
from collections.abc import Generator
from typing import NoReturn

import pytest

import probe
from probe.api.suites import build_suite
from probe.cli import collect, suite
from probe.cli.suite_verify import verify
from probe.cli.teaching import TeachingSetup
from probe.errors import Unfinished
from probe.train.collect.batches import CollectedBatches

TOLD = "are set aside for"


def default(function, name="pool"):
    return inspect.signature(function).parameters[name].default


def test_training_tasks_are_made_of_what_is_for_training_and_suites_of_the_rest():
    assert TeachingSetup().pool == "train"
    assert {spec.id for spec in TeachingSetup().training().specs}.isdisjoint(
        spec.id for spec in probe.open_library("evaluation").specs
    )
    assert default(suite.build) == default(build_suite) == "evaluation"
    # By what the suite says.
    assert default(verify) is None


def test_an_earlier_library_is_still_there(cache):
    assert len(probe.open_library("procedural").specs) == 965


@pytest.mark.parametrize(
    ("pool", "told"),
    [("train", None), ("evaluation", "set aside for evaluation"), ("procedural-2", TOLD)],
)
def test_collecting_with_objects_for_evaluation_is_told(tmp_path, monkeypatch, capsys, pool, told):
    monkeypatch.setattr(collect, "_watched", lambda *_: CollectedBatches())
    monkeypatch.setattr(collect, "hands_of", lambda *_: None)
    with pytest.raises(Unfinished):
        collect.collect(tmp_path / "out", site=TeachingSetup(pool=pool))
    said = " ".join(capsys.readouterr().out.split())
    assert (TOLD in said) == (told is not None)
    assert told is None or (told in said and f"--pool {pool}" in said)
    assert json.loads((tmp_path / "out/collection.json").read_text())["pool"] == pool


def nothing_is_made(*_: object) -> Generator[NoReturn]:
    yield from ()


@pytest.mark.slow
@pytest.mark.parametrize("pool", ["evaluation", "train", "procedural-2", "procedural"])
def test_a_suite_of_objects_for_training_is_told(tmp_path, monkeypatch, capsys, pool):
    monkeypatch.setattr(suite, "make_tasks", nothing_is_made)
    with pytest.raises(Unfinished):
        suite.build(tmp_path / "mine.json", counts={"size": 1}, public=True, pool=pool)
    said = " ".join(capsys.readouterr().out.split())
    assert ("set aside for training" in said) == (pool in ("train", "procedural-2"))
    assert json.loads((tmp_path / "mine.parts/making.json").read_text())["pool"] == pool
