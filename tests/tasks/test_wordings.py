from __future__ import annotations

import pytest

from probe.errors import BadData
from probe.tasks.task import KINDS
from probe.tasks.wordings import parse_wordings, wordings

GOOD = """kind: beneath
wordings:
  - What is under the {cover}?
  - What lies under the {cover}?
  - What is beneath the {cover}?
  - What lies beneath the {cover}?
  - What does the {cover} hide?
"""


@pytest.mark.parametrize("kind", KINDS)
def test_every_type_can_be_asked_in_five_ways_and_more(kind):
    texts = wordings(kind)
    assert len(set(texts)) == len(texts) >= 5
    for text in texts:
        asked = text.format(cover="white bowl", names="red mugs")
        assert "{" not in asked


def test_valid_wordings_are_read():
    assert parse_wordings(GOOD, "beneath.yaml")[4] == "What does the {cover} hide?"


@pytest.mark.parametrize(
    ("old", "new", "line", "reason"),
    [
        ("beneath the {cover}?", "beneath it?", 5, "slots are none"),
        ("beneath the {cover}?", "beneath the {names}?", 5, "wanted exactly: {cover}"),
        ("beneath the {cover}?", "beneath the {cover?", 5, "braces"),
        ("beneath the {cover}?", "beneath the {cover}", 5, "ends with"),
        ("  - What is beneath", "  - what is beneath", 5, "begins with a capital"),
        ("What lies beneath", "What is beneath", 2, "is there twice"),
        ("  - What is beneath the {cover}?\n", "  - 12\n", 5, "valid string"),
        ("  - What does the {cover} hide?\n", "", 2, "at least 5"),
        ("kind: beneath", "kind: below", 1, "'beneath', 'count' or 'find'"),
        ("kind: beneath\n", "kind: beneath\nauthor: me\n", 2, "Extra inputs"),
        ("  - What is beneath", "  - 'What is beneath", 8, "unexpected end"),
        ("wordings:\n", "", 1, "kind"),
    ],
)
def test_broken_wordings_name_file_and_line(old, new, line, reason):
    assert old in GOOD
    with pytest.raises(BadData, match=rf"^some\.yaml: line {line}\b") as caught:
        parse_wordings(GOOD.replace(old, new, 1), "some.yaml")
    assert reason in str(caught.value)


@pytest.mark.parametrize("text", ["", "- a\n- b\n", "just words", "\x00"])
def test_what_is_no_mapping_is_refused(text):
    with pytest.raises(BadData, match=r"^some\.yaml: "):
        parse_wordings(text, "some.yaml")
