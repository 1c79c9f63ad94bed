import pytest

from probe.episodes.remarks import Remark, add_remark, latest, read_remarks
from probe.errors import BadData

FIRST = Remark("t-1", "Ada", True, "two \u201climes\u201d\nor more")
SECOND = Remark("t-1", "Ada", False)
OTHER = Remark("t-1", "Bea", True)


def test_remarks_are_kept_in_order_and_the_last_word_stands(tmp_path):
    assert read_remarks(tmp_path) == []
    for remark in (FIRST, OTHER, SECOND):
        add_remark(tmp_path, remark)
    assert read_remarks(tmp_path) == [FIRST, OTHER, SECOND]
    assert latest(read_remarks(tmp_path)) == {("t-1", "Ada"): SECOND, ("t-1", "Bea"): OTHER}


def test_a_broken_line_is_named(tmp_path):
    add_remark(tmp_path, FIRST)
    with (tmp_path / "remarks.jsonl").open("a") as file:
        file.write('{"task": "t-1"}\n')
    with pytest.raises(BadData, match=r"remarks.jsonl, line 2: agent"):
        read_remarks(tmp_path)
