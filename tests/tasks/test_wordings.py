from __future__ import annotations

from collections import Counter
from string import Formatter

import pytest

from probe.errors import BadData
from probe.tasks.task import QUESTION_TYPES
from probe.tasks.type_rules import rules_of
from probe.tasks.wordings import FEWEST, parse_wordings, wordings

LINES = [f"    - What is under the {{cover}}, way {number}?" for number in range(FEWEST - 1)]
GOOD = "\n".join(
    ["question_type: beneath", "forms:", "  plain:", *LINES, "    - What of the {cover}?\n"]
)


@pytest.mark.parametrize("question_type", QUESTION_TYPES)
def test_every_type_can_be_asked_in_twenty_ways(question_type):
    texts = [wording.text for wording in wordings(question_type)]
    assert len(set(texts)) == len(texts) == 20
    for text in texts:
        slots = {slot for _, slot, _, _ in Formatter().parse(text) if slot}
        assert slots in rules_of(question_type).forms.values()
        assert "{" not in text.format(**dict.fromkeys(slots, "red mug"))


@pytest.mark.parametrize("question_type", ["compare", "ranked", "size"])
def test_each_form_is_asked_about_as_often(question_type):
    assert set(Counter(wording.form for wording in wordings(question_type)).values()) == {6, 7}


def test_valid_wordings_are_read():
    last = parse_wordings(GOOD, "beneath.yaml")[-1]
    assert (last.form, last.text) == ("plain", "What of the {cover}?")


@pytest.mark.parametrize(
    ("old", "new", "line", "reason"),
    [
        ("under the {cover}, way 1?", "under it?", 5, "slots are none"),
        ("under the {cover}, way 1?", "under the {names}?", 5, "wanted exactly: {cover}"),
        ("under the {cover}, way 1?", "under the {cover?", 5, "braces"),
        ("under the {cover}, way 1?", "under the {cover}", 5, "ends with"),
        ("- What is under the {cover}, way 1?", "- what is the {cover}?", 5, "with a capital"),
        ("way 2?", "way 1?", 2, "is there twice"),
        ("- What is under the {cover}, way 1?", "- 12", 5, "valid string"),
        ("    - What of the {cover}?\n", "", 2, "at least 20"),
        ("question_type: beneath", "question_type: below", 1, "'beneath', 'budgeted'"),
        ("question_type: beneath\n", "question_type: beneath\nauthor: me\n", 2, "Extra inputs"),
        ("- What of", "- 'What of", 24, "unexpected end"),
        ("  plain:", "  longer:", 2, "the forms of beneath are plain"),
        ("  plain:", "  nicer:", 2, "the forms of beneath are plain"),
        ("question_type: beneath\n", "", 1, "question_type"),
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
