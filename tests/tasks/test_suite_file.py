from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import pytest

from probe.errors import BadData
from probe.perception.dials import Dials
from probe.tasks.headline import HeadlineErrors
from probe.tasks.suite import Suite, part
from probe.tasks.suite_file import (
    content_hash,
    find_suite,
    packaged_suite,
    read_suite,
    write_suite,
)
from probe.tasks.task import LETTERS
from task_examples import FIND, SCENE, with_answer

FINGERPRINTS = {placed.object_id: (3.0, 0.5) for placed in SCENE.objects}
SUITE = Suite(
    "small",
    (FIND, replace(with_answer("E"), id="count-1", question_type="count", subject="lime", cover=1)),
    FINGERPRINTS,
)


@pytest.fixture
def path(tmp_path: Path) -> Path:
    path = tmp_path / "small.json"
    write_suite(path, SUITE)
    return path


def test_a_suite_comes_back_bit_for_bit(path: Path):
    assert read_suite(path) == SUITE
    written = path.read_bytes()
    write_suite(path, read_suite(path))
    assert path.read_bytes() == written


def test_the_pool_it_was_made_of_is_kept_and_left_out_where_nobody_wrote_it_down(path: Path):
    assert "pool" not in json.loads(path.read_text())
    plain = content_hash(SUITE)
    write_suite(path, replace(SUITE, pool="train"))
    assert json.loads(path.read_text())["pool"] == "train"
    assert read_suite(path).pool == "train"
    assert content_hash(read_suite(path)) != plain
    edit(path, ["pool"], "everything")
    with pytest.raises(BadData, match="pool"):
        read_suite(path)


def test_how_many_manipulations_a_task_allows_is_kept_and_left_out_where_that_is_as_usual(
    path: Path,
):
    assert "manipulations" not in json.loads(path.read_text())["tasks"][0]
    first, *rest = SUITE.tasks
    write_suite(path, replace(SUITE, tasks=(replace(first, manipulations=3), *rest)))
    assert json.loads(path.read_text())["tasks"][0]["manipulations"] == 3
    assert [task.manipulations for task in read_suite(path).tasks] == [3, *[None] * len(rest)]
    assert content_hash(read_suite(path)) != content_hash(SUITE)
    edit(path, ["tasks", 0, "manipulations"], 0)
    with pytest.raises(BadData, match="manipulations"):
        read_suite(path)


def test_the_headline_setting_is_kept_and_left_out_where_there_is_none(path: Path):
    assert "headline" not in path.read_text()
    headline = HeadlineErrors(
        0.018, 0.0, Dials(over=0.1, under=0.05, missed=0.02, hallucinated=0.01)
    )
    write_suite(path, replace(SUITE, headline=headline))
    assert "general" not in path.read_text()  # as in suites of before there was such a rate
    again = read_suite(path)
    assert again.headline == headline
    assert part(again, again.tasks[0]).headline == headline
    assert content_hash(again) != content_hash(SUITE)
    coarse = replace(headline, dials=replace(headline.dials, general=0.5))
    write_suite(path, replace(SUITE, headline=coarse))
    assert read_suite(path).headline == coarse


def test_it_carries_a_canary(path: Path):
    assert "canary" in json.loads(path.read_text())["canary"]


@pytest.mark.parametrize("share", [0.0, 0.3, 0.9, 0.999])
def test_a_truncated_file_is_refused(path: Path, share):
    content = path.read_bytes()
    path.write_bytes(content[: int(len(content) * share)])
    with pytest.raises(BadData, match=r"small\.json: .*probe suite build"):
        read_suite(path)


def test_a_missing_file_is_refused(tmp_path: Path):
    with pytest.raises(BadData, match="No such file"):
        read_suite(tmp_path / "none.json")


def edit(path: Path, place: list, value: object) -> None:
    """Change one value of a JSON file, and leave its checksum out."""
    content = json.loads(path.read_text())
    del content["sum"]
    inner = content
    for key in place[:-1]:
        inner = inner[key]
    inner[place[-1]] = value
    path.write_text(json.dumps(content))


@pytest.mark.parametrize(
    ("place", "value", "reason"),
    [
        (["version"], 1, "version"),
        (["canary"], "", "canary"),
        (["tasks", 0, "answer"], "C", "find-0123abcd isn't what it was"),
        (["tasks", 0, "scene", "objects", 1, "position", 0], 0.11, "isn't what it was"),
        (["tasks", 0, "answer"], "F", "tasks.0.answer"),
        (["tasks", 0, "kind"], "guess", "tasks.0.kind"),
        (["tasks", 0, "targets"], [9], r"tasks.0: .*instances \[9\]"),
        (["tasks", 1, "id"], "find-0123abcd", "twice"),
        (["manifest"], {}, "manifest differ"),
        (["objects"], {}, "which has no fingerprint"),
    ],
)
def test_an_edited_suite_is_refused_by_place(path: Path, place, value, reason):
    edit(path, place, value)
    with pytest.raises(BadData, match=reason):
        read_suite(path)


def test_letters_keep_their_texts(path: Path):
    task = read_suite(path).tasks[0]
    assert [option.letter for option in task.options] == list(LETTERS)
    assert task.options[1].text == "lime"


def test_a_folder_called_like_a_packaged_suite_is_not_taken_for_it(tmp_path: Path, monkeypatch):
    """`probe run demo --out demo`, the second time."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "demo").mkdir()
    assert find_suite("demo") == packaged_suite("demo")
    (tmp_path / "other").mkdir()
    with pytest.raises(BadData, match="is a folder"):
        find_suite("other")
