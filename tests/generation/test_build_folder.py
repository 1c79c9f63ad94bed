"""The folder in which a suite grows."""

from __future__ import annotations

import pytest

from probe.errors import BadData
from probe.generation.build_folder import KEPT, BuildFolder, BuildSettings, CandidateLog, TaskSlot

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
    parts.claim(BuildSettings(pool="procedural", unchecked=True))
    with pytest.raises(BadData, match=r"making\.json: was begun with unchecked True, not False"):
        parts.claim(BuildSettings(pool="procedural", unchecked=False))
