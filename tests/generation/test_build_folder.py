"""The folder in which a suite grows."""

from __future__ import annotations

import stat
from dataclasses import replace
from pathlib import Path

import pytest

from probe.assets.library import open_library
from probe.errors import BadData
from probe.generation.build_folder import KEPT, BuildFolder, BuildSettings, CandidateLog, TaskSlot
from probe.scene.setup import ROOM_TABLE
from probe.scene.setup_file import SetupDocument
from probe.tasks.suite_file import demo_suite, write_suite

PLACE = TaskSlot("count", 7)


def line(check: str, seed: int = 7000) -> CandidateLog:
    return CandidateLog("count", seed, check, None, "two\tof them\noverlap", 1.25)


def test_a_log_comes_back_as_it_was_written(tmp_path):
    parts = BuildFolder(tmp_path)
    parts.add(PLACE, line("settle"))
    parts.add(PLACE, line(KEPT, 7001))
    first, second = parts.log(PLACE)
    assert (first.check, first.detail, first.solved) == ("settle", "two of them overlap", None)
    assert (second.seed, second.check) == (7001, "kept")
    assert parts.log_path(PLACE).read_text().splitlines()[0] == (
        "count\t7000\tsettle\t-\ttwo of them overlap\t1.2"
    )


def mode(path: Path) -> int:
    return stat.S_IMODE(path.stat().st_mode)


@pytest.mark.parametrize("commitment", [None, "0" * 64])
def test_what_is_private_is_its_owners_alone(tmp_path, cache, commitment):
    """Also in a folder that was there before, as on a machine that a salt was carried to."""
    parts = BuildFolder(tmp_path / "mine.parts")
    parts.folder.mkdir(mode=0o755)
    parts.claim(BuildSettings(pool="procedural", unchecked=True, commitment=commitment))
    parts.add(PLACE, line("settle"))
    task, library = demo_suite().tasks[0], open_library("procedural", None, cache)
    parts.keep(PLACE, task, library)
    parts.keep_unsolved(task, library)
    modes = {mode(path) for path in parts.folder.iterdir()}
    assert len(list(parts.folder.iterdir())) == 4
    assert (mode(parts.folder), modes) == ((0o700, {0o600}) if commitment else (0o755, {0o644}))
    suite = replace(demo_suite(), name="mine", commitment=commitment)
    write_suite(tmp_path / "mine.json", suite)
    assert mode(tmp_path / "mine.json") == (0o600 if commitment else 0o644)


def test_a_folder_is_taken_up_again_as_it_was_begun(tmp_path):
    parts, room = BuildFolder(tmp_path), SetupDocument.of(ROOM_TABLE)
    making = BuildSettings(pool="procedural", unchecked=True, setup=room)
    parts.claim(making)
    parts.claim(making)
    other = SetupDocument.of(replace(ROOM_TABLE, lighting="cellar"))
    with pytest.raises(BadData, match=r"making\.json: was begun with another setup"):
        parts.claim(making.model_copy(update={"setup": other}))
    with pytest.raises(BadData, match="was begun with pool procedural, not scans"):
        parts.claim(making.model_copy(update={"pool": "scans"}))


def test_places_have_logs_of_their_own(tmp_path):
    parts = BuildFolder(tmp_path)
    parts.add(PLACE, line("settle"))
    assert parts.log(TaskSlot("count", 8)) == parts.log(TaskSlot("find", 7)) == []


@pytest.mark.parametrize("text", ["count\t7000", "count\tx\tkept\t-\t\t1.0", "\x00"])
def test_a_broken_log_is_named(tmp_path, text):
    parts = BuildFolder(tmp_path)
    parts.log_path(PLACE).write_text(text + "\n")
    with pytest.raises(BadData, match=r"count-7\.tsv: .*Delete it"):
        parts.log(PLACE)


def test_a_candidate_that_two_processes_tried_counts_once(tmp_path):
    parts = BuildFolder(tmp_path)
    for check in ("nest", "nest"):
        parts.add(PLACE, line(check))
    parts.add(PLACE, line(KEPT, 7001))
    assert [each.seed for each in parts.log(PLACE)] == [7000, 7001]


def test_a_folder_of_unchecked_tasks_is_no_start_for_checked_ones(tmp_path):
    parts = BuildFolder(tmp_path)
    parts.claim(BuildSettings(pool="procedural", unchecked=True))
    with pytest.raises(BadData, match=r"making\.json: was begun with rules 2, not 3"):
        parts.claim(BuildSettings(pool="procedural", unchecked=True, rules=3))
    with pytest.raises(BadData, match=r"making\.json: was begun with unchecked True, not False"):
        parts.claim(BuildSettings(pool="procedural", unchecked=False))
