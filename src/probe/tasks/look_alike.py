"""Names that people take for a packaged suite's, though they are others. Pure."""

from __future__ import annotations

from collections.abc import Iterable
from unicodedata import category, normalize

_UNCOUNTED = "MZCP"
"""First letters of Unicode's categories of marks, spaces, signs that don't show, punctuation."""

_SAME = {
    "0": "oοоօσᴏ", "1": "il|ιіӏıɩʟ", "a": "αаɑᴀ", "c": "сϲᴄ", "d": "ԁɗđᴅ", "e": "εеєҽᴇ", "f": "ғƒ",
    "m": "μмᴍ", "n": "ηпոᴎɴ", "r": "гᴦʀ", "s": "ѕꜱ", "t": "τтᴛ", "u": "υսᴜ", "v": "νѵᴠ",
}  # fmt: skip
"""Small letters that look like another sign, or nearly: Latin, Greek, Cyrillic, Armenian ones."""

_FOLDS = {ord(sign): to for to, signs in _SAME.items() for sign in signs}


def look_alike(name: str, known: Iterable[str]) -> str | None:
    """Of some names the one that this isn't, but can be taken for; None if there is none.

    Case, spaces, punctuation and signs that don't show count for nothing, and signs that look
    alike are one. What isn't ASCII and isn't known may look like anything, if half of the name is.
    """
    names = list(known)
    if name in names:
        return None
    mine = _folded(name)
    return next((it for it in names if _alike(mine, _folded(it))), None)


def _folded(name: str) -> str:
    text = normalize("NFKD", normalize("NFKD", name).casefold())
    return "".join(it for it in text if category(it)[0] not in _UNCOUNTED).translate(_FOLDS)


def _alike(mine: str, known: str) -> bool:
    pairs = list(zip(mine, known, strict=False))
    same = sum(one == other for one, other in pairs)
    seen = all(one == other or not one.isascii() for one, other in pairs)
    return len(mine) == len(known) and seen and 2 * same >= len(known)
