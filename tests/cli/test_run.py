"""`probe run` short of an episode: folders that it leaves as they are."""

from dataclasses import replace
from importlib import import_module

import pytest

from probe.cli.run import run_suite
from probe.episodes.files import append_record
from probe.episodes.folder import RECORDS, SUITE
from probe.episodes.luck import NO_NOISE, NOISES
from probe.episodes.record import EpisodeRecord, Table
from probe.episodes.turns import Question
from probe.errors import BadData
from probe.scene.scene import Scene
from probe.tasks.suite_file import demo_suite, write_suite

EMPTY = Table(Scene(0, "oak", ()), (0.0,) * 6)
RECORD = EpisodeRecord("t-1", "random", 0, Question("What?", ()), EMPTY, (), None, "stopped", None)


@pytest.fixture
def suite(monkeypatch):
    monkeypatch.delenv("PROBE_ASSETS", raising=False)
    # Objects would have to be made first, which takes minutes.
    command = import_module("probe.cli.run")
    monkeypatch.setattr(command, "check_objects", lambda suite, things: None)
    return demo_suite()


def test_a_folder_of_another_suite_is_refused(suite, tmp_path):
    path = tmp_path / "out" / SUITE
    write_suite(path, replace(suite, name="other"))
    before = path.read_bytes()
    with pytest.raises(BadData, match="another suite. Choose another folder"):
        run_suite(suite, "random", tmp_path / "out", 1, NO_NOISE)
    assert path.read_bytes() == before


def test_another_noise_is_refused_before_anything_is_written(suite, tmp_path):
    append_record(tmp_path / "out" / RECORDS, RECORD)
    with pytest.raises(BadData, match="another noise. Choose another folder"):
        run_suite(suite, "random", tmp_path / "out", 1, NOISES["paper"])
    assert [path.name for path in (tmp_path / "out").iterdir()] == [RECORDS]
