"""Texts made fit for a terminal and a spreadsheet, and back."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from probe.texts import cell, line, uncell, visible, writable

ANYTHING = st.text(st.characters(exclude_categories=[]))


@given(ANYTHING)
def test_nothing_that_steers_a_terminal_is_left(text):
    shown = visible(text)
    shown.encode()
    for sign in shown:
        assert sign == "\n" or sign >= " "
        assert not 0x7F <= ord(sign) <= 0x9F
        assert sign not in "\u061c\u200e\u200f\u2028\u2029\ufeff"
        assert not "\u202a" <= sign <= "\u202e" and not "\u2066" <= sign <= "\u2069"
    assert "\n" not in line(text)


@pytest.mark.parametrize(
    ("text", "shown"),
    [
        ("Ein Haus, 寿司 🍣 é", "Ein Haus, 寿司 🍣 é"),
        ("\x1b[31mred\x9b", r"\x1b[31mred\x9b"),
        ("a\u202eb", r"a\u202eb"),
        ("half \ud800", r"half \ud800"),
        ("[/red]", "[/red]"),
        ("👩\u200d🔬", "👩\u200d🔬"),
    ],
)
def test_signs_stand_for_themselves_or_are_named(text, shown):
    assert visible(text) == shown


@given(ANYTHING)
def test_a_cell_is_no_formula_and_comes_back(text):
    written = cell(text)
    assert not written.startswith(("=", "+", "-", "@", "\t", "\r", "\n"))
    assert uncell(written) == text


@pytest.mark.parametrize("text", ["=1", "'=1", "''=1", "'tis", "-", "", "a=b"])
def test_cells(text):
    assert uncell(cell(text)) == text
    assert (cell(text) == text) == (text.lstrip("'")[:1] not in ("=", "-"))


def test_what_an_old_table_has_is_read_as_it_stands():
    assert uncell("=HYPERLINK(1)") == "=HYPERLINK(1)"


def test_halves_of_pairs_are_written_as_question_marks():
    assert writable("a\ud800b\udfff") == "a?b?"
