"""What v0.1 gave is still given: frozen tasks, its records, their scores and their report."""

from __future__ import annotations

import gzip
import hashlib
import json
import shutil
from pathlib import Path

import pytest

from golden.digests import CHOSEN, GOLDEN, chosen, digests, looks
from probe.api.resources import everything
from probe.cli.audit import audit
from probe.cli.report import write_run_report
from probe.cli.rescore import rescore
from probe.episodes.files import line_of, read_records, write_records
from probe.episodes.replay import OtherTools
from probe.render.renderer import Renderer
from probe.tasks.suite_file import demo_suite, write_suite

RECORDS = Path(__file__).parent / "records"
EXPECTED: dict[str, dict[str, str]] = json.loads(GOLDEN.read_text())
REPORTED = "beneath-2da3b9f2", "find-c09c4db2"
REPORT = "dd6a34c560610e0c2458079b27b57fe4ecd7e7e5a1a006702f4f9207a548d41f"
"""SHA-256 of the names and contents of a report's episodes on these tasks, in order. The same files
had it in a report of all six tasks whose own hash was still v0.1's.

Since v0.1 only the names of pictures are others, for a report draws them in full size.
"""


@pytest.fixture(scope="module")
def things():
    with Renderer() as renderer:
        yield everything(), renderer


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A run that v0.1 kept: two agents of ours and a model in two settings, six tasks each."""
    out = tmp_path / "run"
    out.mkdir()
    (out / "records.jsonl").write_bytes(
        gzip.decompress((RECORDS / "records.jsonl.gz").read_bytes())
    )
    shutil.copy(RECORDS / "ordered.json", out)
    write_suite(out / "suite.json", demo_suite())
    return out


@pytest.mark.slow
@pytest.mark.parametrize(("suite", "question_type"), CHOSEN)
def test_a_frozen_task_looks_and_plays_as_it_did(things, request, suite: str, question_type: str):
    if suite == "v1-scans":
        request.getfixturevalue("assets")
    library, renderer = things
    task, expected = chosen(suite, question_type), EXPECTED[f"{suite} {question_type}"]
    if suite == "v1" or (suite, question_type) == ("v1-scans", "beneath"):
        assert digests(task, library, renderer) == expected
    else:
        assert looks(task, library, renderer).items() <= expected.items()


def test_records_are_read_as_they_were(folder: Path):
    records = read_records(folder / "records.jsonl")
    assert len(records) == 24
    assert b"".join(map(line_of, records)) == (folder / "records.jsonl").read_bytes()


@pytest.mark.slow
def test_records_are_scored_as_they_were(folder: Path):
    rescore(folder)
    for name in ("rows.csv", "scores.json"):
        assert (folder / name).read_bytes() == (RECORDS / name).read_bytes(), name


@pytest.mark.slow
def test_records_are_reported_as_they_were(folder: Path):
    path = folder / "records.jsonl"
    write_records(path, [record for record in read_records(path) if record.task in REPORTED])
    write_run_report([folder])
    found = hashlib.sha256()
    for path in sorted((folder / "episodes").iterdir()):
        found.update(path.name.encode() + path.read_bytes())
    assert found.hexdigest() == REPORT


def test_records_are_not_replayed_by_other_tools(folder: Path):
    assert {record.tools for record in read_records(folder / "records.jsonl")} == {1}
    with pytest.raises(OtherTools, match=r"Install probe-vqa 0\.1"):
        audit(folder, replay="all")
