"""Texts in lines that fit."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st
from PIL import Image, ImageDraw

from probe.film.lettering import font, wrapped, write

words = st.text(st.characters(min_codepoint=33, max_codepoint=126), min_size=1, max_size=40)


@given(text=st.lists(words, max_size=12).map(" ".join), width=st.integers(40, 300))
def test_no_line_is_too_wide_and_no_sign_is_lost(text: str, width: int) -> None:
    lines = wrapped(text, font(16), width)
    assert all(font(16).getlength(line) <= width for line in lines)
    assert "".join(lines).replace(" ", "") == text.replace(" ", "")


def test_what_doesn_t_fit_ends_in_dots_within_its_room() -> None:
    picture = Image.new("RGB", (200, 200))
    pen = ImageDraw.Draw(picture)
    used = write(pen, (10, 10), "word " * 200, 16, (255, 255, 255), (150, 70))
    assert used <= 70
    left, top, right, bottom = picture.getbbox() or (0, 0, 0, 0)
    assert left >= 10 and top >= 10
    assert right <= 162 and bottom <= 84
