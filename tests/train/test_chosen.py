from __future__ import annotations

import pytest

from probe.errors import BadData
from probe.train.chosen import read_selection
from train.conftest import LESSONS


def test_a_selection_comes_back(selection):
    chosen = read_selection(selection())
    assert sorted(map(repr, chosen.episodes)) == sorted(
        repr((it.task, it.record)) for it in LESSONS
    )
    assert chosen.document.examples == {
        "count": {"direct": 0, "agentic": 1}, "find": {"direct": 1, "agentic": 1}
    }  # fmt: skip
    assert chosen.document.suites == ("v1",)


@pytest.mark.parametrize("name", ["records.jsonl", "suite.json"])
def test_a_file_that_was_cut_off_is_named(selection, name):
    folder = selection()
    path = folder / name
    path.write_bytes(path.read_bytes()[:-100])
    with pytest.raises(BadData, match=rf"{name}: isn't what was selected.*probe select"):
        read_selection(folder)
    path.unlink()
    with pytest.raises(BadData, match=rf"{name}: No such file.*probe select"):
        read_selection(folder)


def test_half_a_selection_is_none(selection):
    folder = selection()
    (folder / "selection.json").unlink()
    with pytest.raises(BadData, match=r"selection.json: No such file.*Select anew"):
        read_selection(folder)
    with pytest.raises(BadData, match="holds something already"):
        selection()
