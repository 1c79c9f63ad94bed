"""One object alone before the camera: where it is in the picture, and what it looks like."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from scipy import ndimage

from probe.errors import ProbeError
from probe.perception.enrolled.signature import Signature, signature_of
from probe.perception.relief import raised
from probe.types import Array, Frame

LEAST_PX = 200
"""Pixels that an object has to show to be enrolled."""

_STRAY_SHARE = 0.2
_CLOSED_PX = 3


class NotAlone(ProbeError):
    """A picture for an enrolment doesn't show one object alone."""

    def __init__(self, found: str) -> None:
        super().__init__(
            f"The picture shows {found}. Put one object alone on the bare table, wholly in view, "
            "and take the hand away."
        )


def lone_thing(frame: Frame) -> Array:
    """Pixels of the only object on a table whose top is the plane z = 0.

    Args:
        frame: With depth in metres; places without a reading are left out.

    Returns:
        bool, shape (h, w).

    Raises:
        NotAlone: There is nothing, there are several things, or one is cut off by the border.
    """
    above = raised(frame, np.where(frame.depth > 0, frame.depth, np.nan))
    whole = ndimage.binary_closing(above, iterations=_CLOSED_PX) | above
    numbers, count = ndimage.label(whole)
    sizes = np.bincount(numbers.ravel(), minlength=count + 1)
    sizes[0] = 0
    if sizes.max(initial=0) < LEAST_PX:
        raise NotAlone("nothing on the table")
    others = np.sort(sizes)[:-1]
    if others.max(initial=0) > _STRAY_SHARE * sizes.max():
        raise NotAlone("more than one thing")
    mask = (numbers == int(sizes.argmax())) & above
    if mask[[0, -1]].any() or mask[:, [0, -1]].any():
        raise NotAlone("a thing that its border cuts off")
    return mask


def shown(frames: Sequence[Frame]) -> tuple[Signature, ...]:
    """The signatures of one object, from a picture of each pose that an operator shows it in.

    Args:
        frames: Each with the object alone on the table, with colours and depth.

    Raises:
        NotAlone: One of them shows something else.
    """
    return tuple(signature_of(frame, lone_thing(frame)) for frame in frames)
