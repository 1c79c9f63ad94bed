"""Lines of text on a picture. Knows no film."""

from __future__ import annotations

from functools import lru_cache

from PIL import ImageDraw, ImageFont

Font = ImageFont.FreeTypeFont | ImageFont.ImageFont
Ink = tuple[int, int, int]


@lru_cache
def font(size_px: int) -> Font:
    """The font that comes with Pillow."""
    return ImageFont.load_default(size_px)


def wrapped(text: str, face: Font, width_px: int) -> list[str]:
    """The text in lines that are no wider; a longer word is split."""
    lines: list[str] = []
    for paragraph in text.splitlines():
        line = ""
        for word in paragraph.split(" "):
            longer = f"{line} {word}" if line else word
            while face.getlength(longer) > width_px:
                cut = line or _start(word, face, width_px)
                lines.append(cut)
                word = word if line else word[len(cut) :]
                line, longer = "", word
            line = longer
        lines.append(line)
    return lines


def write(
    pen: ImageDraw.ImageDraw,
    place: tuple[int, int],
    text: str,
    size_px: int,
    ink: Ink,
    room: tuple[int, int],
) -> int:
    """Write a text in lines.

    Args:
        pen: Of the picture.
        place: Its top left corner, pixels.
        text: What to write.
        size_px: Of the letters.
        ink: Their colour.
        room: Width and height at most, pixels; what doesn't fit ends in dots.

    Returns:
        The height that was taken, pixels.
    """
    face, step = font(size_px), round(1.3 * size_px)
    lines, most = wrapped(text, face, room[0]), max(0, room[1] // step)
    if len(lines) > most:
        lines = lines[:most]
        if lines:
            lines[-1] = _dotted(lines[-1], face, room[0])
    for number, line in enumerate(lines):
        pen.text((place[0], place[1] + number * step), line, fill=ink, font=face)
    return len(lines) * step


def _start(word: str, face: Font, width_px: int) -> str:
    """The longest beginning of a word that fits, at least one sign."""
    count = 1
    while count < len(word) and face.getlength(word[: count + 1]) <= width_px:
        count += 1
    return word[:count]


def _dotted(line: str, face: Font, width_px: int) -> str:
    """A line that ends in dots, to say that more followed."""
    while line and face.getlength(line + " ...") > width_px:
        line = line[:-1]
    return line.rstrip() + " ..."
