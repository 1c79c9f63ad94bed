"""Which things can hide others beneath them, by what they are called: common knowledge."""

from __future__ import annotations

from typing import Literal

from probe.perception.tokens import tokens

Hider = Literal["hollow", "flat"]

_HOLLOW = frozenset((
    "basin", "basket", "bin", "bowl", "box", "bucket", "cap", "case", "colander",
    "crate", "cup", "dish", "dome", "drawer", "frisbee", "funnel", "goblet", "hat",
    "helmet", "jug", "ladle", "lid", "mortar", "mug", "pan", "pitcher", "planter",
    "pot", "saucepan", "scoop", "shade", "shell", "shoe", "shuttlecock", "sieve",
    "skillet", "strainer", "tin", "tray", "trough", "tumbler", "vase",
    "container", "cookware", "vessel",  # as kinds are told
))  # fmt: skip
_FLAT = frozenset((
    "board", "book", "box", "calculator", "cheese", "cloth", "coaster", "dustpan",
    "envelope", "folder", "frame", "keyboard", "magazine", "mat", "notebook", "pad",
    "paddle", "paperback", "phone", "placemat", "plate", "platter", "puck", "racket",
    "record", "saucer", "slate", "tablet", "tile", "tray", "trivet", "wallet",
))  # fmt: skip
# Closed all around, whatever else the name says; and boxes that are sold full.
_CLOSED = frozenset((
    "bottle", "can", "carton", "cone", "jam", "jar", "juice", "marble", "milk",
    "shaker", "stick", "sugar", "tape", "tub",
))  # fmt: skip
_PACKED = frozenset((
    "biscuit", "cereal", "cookie", "cracker", "raisin", "snack", "tea", "tissue",
    "toothpaste",
))  # fmt: skip


def hider(name: str) -> Hider | None:
    """Whether a thing is hollow or flat, as its name lets one expect; None if it is neither.

    A closed box is flat rather than hollow: it may lie on something, not over it.
    """
    words = set(tokens(name))
    if words & _CLOSED:
        return None
    if words & _HOLLOW and not words & _PACKED:
        return "hollow"
    return "flat" if words & _FLAT else None
