"""Private suites on the command line: what is refused, and in which words."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import pytest

from probe.cli.shortcuts import shortcuts
from probe.cli.suite import build
from probe.cli.suite_verify import Unverified, verify
from probe.errors import BadData
from probe.generation.salt import Salt
from probe.tasks.suite import selection
from probe.tasks.suite_file import demo_suite, digest_of, write_suite

SALT = Salt(bytes(range(32)))
TASK = demo_suite().tasks[0]


def salt_file(folder: Path, salt: Salt) -> Path:
    path = folder / "salt.json"
    path.write_text(json.dumps({"version": 1, "salt": salt.secret.hex()}))
    return path


@pytest.fixture
def private(tmp_path) -> Path:
    """A suite that claims to be of a salt; its task isn't."""
    path = tmp_path / "mine.json"
    suite = replace(selection(demo_suite(), (TASK,), "mine"), commitment=SALT.commitment)
    write_suite(path, suite)
    return path


def test_a_private_suite_has_no_first_number(tmp_path):
    with pytest.raises(BadData, match="--first: .*Say --public too"):
        build(tmp_path / "mine.json", {"find": 1}, first=7)
    assert list(tmp_path.iterdir()) == []


def test_no_suite_is_built_under_a_name_like_a_packaged_ones(tmp_path):
    for name in ("Demo", "v1_"):
        with pytest.raises(BadData, match="looks like the packaged"):
            build(tmp_path / f"{name}.json", {"find": 1})
    assert list(tmp_path.iterdir()) == []


def test_without_its_salt_a_private_suite_cant_be_made_again(private):
    with pytest.raises(BadData, match="--rebuild: needs the salt of mine.*--salt FILE"):
        verify(str(private), rebuild=1)


def test_another_salt_is_refused(private, tmp_path):
    path = salt_file(tmp_path, Salt(bytes(32)))
    with pytest.raises(BadData, match=r"salt\.json: isn't the salt that suite mine"):
        verify(str(private), salt=path)


def test_a_public_suite_has_no_salt(tmp_path):
    with pytest.raises(BadData, match="--salt: demo is a public suite"):
        verify("demo", salt=salt_file(tmp_path, SALT))


def test_tasks_that_dont_follow_from_the_salt_fail(private, tmp_path, capsys):
    out = tmp_path / "verdicts"
    out.mkdir()
    (out / f"{TASK.id}.json").write_text(
        json.dumps(
            {
                "task": TASK.id, "kind": TASK.question_type, "digest": digest_of(TASK),
                "problems": {"text": []}, "solved": True,
            }
        )
    )  # fmt: skip
    with pytest.raises(Unverified, match="1 tasks of suite mine"):
        verify(str(private), out, rebuild=1, salt=salt_file(tmp_path, SALT))
    said = capsys.readouterr().out
    assert "the one that mine is committed to" in said
    assert f"{TASK.id}: doesn't come from this salt" in said


def test_classifiers_need_a_plan_that_is_known(private):
    with pytest.raises(BadData, match="suite mine: is private.*--public"):
        shortcuts((str(private),))
