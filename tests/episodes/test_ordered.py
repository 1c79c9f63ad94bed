import pytest

from probe.episodes.ordered import ORDERED, note_ordered, read_ordered
from probe.errors import BadData


def test_each_agent_has_a_number_in_each_arm_and_the_larger_one_stands(tmp_path):
    assert read_ordered(tmp_path) == {}
    note_ordered(tmp_path, "anna", "", 2)
    note_ordered(tmp_path, "anna", "direct", 3)
    note_ordered(tmp_path, "anna", "", 1)
    note_ordered(tmp_path, "anna", "direct", 4)
    assert read_ordered(tmp_path) == {("anna", ""): 2, ("anna", "direct"): 4}


@pytest.mark.parametrize("text", ["", "[]", '{"ordered":[{"agent":"a","arm":"","runs":0}]}'])
def test_what_is_no_such_file_is_refused(tmp_path, text):
    (tmp_path / ORDERED).write_text(text)
    with pytest.raises(BadData, match=f"{ORDERED}.*Delete it, and start the same run again"):
        note_ordered(tmp_path, "anna", "", 1)
