"""What the student's page and the README say of it is what its packed records give."""

from __future__ import annotations

import tarfile
from pathlib import Path

import pytest

from probe.cli.held_out import held_out
from probe.cli.ladder import ladder

pytestmark = pytest.mark.slow
ROOT = Path(__file__).parents[1]
RUNS = ("student", "base", "scripted", "middle-number")
LATER = "student-2026-12-01"


@pytest.fixture(scope="module")
def tables(tmp_path_factory):
    """What `probe held-out` and `probe ladder` print of the records."""
    out = tmp_path_factory.mktemp("student")
    with tarfile.open(ROOT / "runs/data/student-v1.tar.xz") as archive:
        archive.extractall(out, filter="data")
    runs = [out / name for name in RUNS]
    learnt = out / "question_only.json"
    held_out(tuple(runs), learnt=learnt, out=out / "table.md")
    ladder(tuple(runs[:2]), out=out / "ladder.md")
    later = (out / LATER,)
    held_out(later, learnt=learnt, out=out / "later.md")
    ladder(later, out=out / "later-ladder.md")
    names = ("table", "ladder", "later", "later-ladder")
    return {name: (out / f"{name}.md").read_text() for name in names}


def test_the_page_has_these_tables(tables: dict[str, str]) -> None:
    page = (ROOT / "docs/results/student.md").read_text("utf-8").splitlines()
    # What the later student is compared with stands beside the first one alone.
    rows = [
        row
        for name, text in tables.items()
        for row in rows_of(text)
        if name != "later" or (row.startswith("| student") and "blind" not in row)
    ]
    assert len(rows) > 14
    assert not [row for row in rows if row not in page]


def rows_of(text: str) -> list[str]:
    return [line for line in text.splitlines() if line.startswith("| ")]


def test_the_readme_has_the_macro_averages(tables: dict[str, str]) -> None:
    readme = " ".join((ROOT / "README.md").read_text("utf-8").split())
    macros = {
        row.split("|")[1].split(",")[0].strip(): row.split("|")[4].strip()
        for row in tables["table"].partition("| first |")[0].splitlines()
        if row.startswith("| ")
    }
    value, _, interval = macros["student"].partition(" ")
    low, high = interval.strip("()").split("-")
    assert f"right in {value} % of the tasks" in readme
    assert f"95 % interval {low} to {high}" in readme
    assert f"the best rule that doesn't look in {macros['middle-number'].split()[0]} %" in readme
