"""Texts made fit for where they go: a file, a terminal, a spreadsheet, a sentence. Pure."""

from __future__ import annotations

import re
from unicodedata import category

_UNSEEN = {"Cc", "Cf", "Cs", "Zl", "Zp"}
"""Unicode's categories of control characters (escape sequences begin with one), of formats (which
turn the direction of what follows), of halves of pairs, and of separators of lines."""

_JOINERS = "\u200c\u200d"
"""Formats that writing and pictures of several signs need."""

_FORMULA = re.compile(r"'*[=+\-@\t\r\n]")
_MARKED = re.compile(r"'+[=+\-@\t\r\n]")


def writable(text: str) -> str:
    """A text as UTF-8 can hold it: halves of surrogate pairs, which models may send, become "?"."""
    return text.encode("utf-8", "replace").decode()


def visible(text: str) -> str:
    """A text as a terminal may get it: what would steer it stands there as in Python.

    Line breaks are kept.
    """
    if text.isprintable():
        return text
    return "".join(map(_visible, text))


def line(text: str) -> str:
    """As visible(), in one line: a line break stands there as in Python, too."""
    return visible(text).replace("\n", "\\n")


def plain(text: str) -> str:
    """A text in printable ASCII; all else stands there as in Python, whatever it looks like."""
    return "".join(it if " " <= it <= "~" else it.encode("unicode_escape").decode() for it in text)


def cell(text: str) -> str:
    """A text as a cell of a table for spreadsheets, which take some beginnings for a formula.

    An apostrophe before it says that it is a text; uncell() takes it away.
    """
    return f"'{text}" if _FORMULA.match(text) else text


def uncell(written: str) -> str:
    """The text that cell() was given."""
    return written[1:] if _MARKED.match(written) else written


def _visible(sign: str) -> str:
    if sign == "\n" or sign in _JOINERS or category(sign) not in _UNSEEN:
        return sign
    return sign.encode("unicode_escape").decode()


def plural(count: int, word: str) -> str:
    """A count with its noun: "1 task", "2 tasks"."""
    return f"{count:,} {word}" + ("" if count == 1 else "s")
