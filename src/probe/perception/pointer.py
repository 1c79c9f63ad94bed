"""Things found by a model that points at what words describe, and a mask of what lies there."""

from __future__ import annotations

import json
from typing import Protocol

from probe.asking import asked
from probe.perception.matching import Match
from probe.perception.places import place_in
from probe.perception.points import IN_WORDS, Convention, read_point
from probe.perception.segmenter import Masker, thing_of
from probe.types import Array, Ask, Frame

_QUESTION = """The picture shows a table from above; it is {width} pixels wide and {height} high.
Point at the one thing in it that this describes: {description}
Choose a place well inside what shows of it. Reply with one JSON object and nothing else:
{{"point": {convention}}}
with numbers in the list. If nothing that shows fits, reply {{"point": null}}."""


class Finder(Protocol):
    """Finds what words describe in a frame that has colours."""

    def find(self, description: str, frame: Frame) -> Match | None:
        """The thing that is meant; None if nothing that shows fits.

        Raises:
            UnusableReply: A model was asked and its reply makes no sense.
            ModelFailed: A model was asked and no reply came.
        """
        ...


class Pointer:
    """A Finder: a model gives a point, a Masker the mask around it.

    The thing it finds is told by its looks alone: what the agent called it isn't repeated.
    """

    def __init__(self, ask: Ask, masker: Masker, convention: Convention = "pixels") -> None:
        """Set up.

        Args:
            ask: The model.
            masker: Says what lies under the point.
            convention: How the model writes points down.
        """
        self._ask = ask
        self._masker = masker
        self._convention: Convention = convention

    def find(self, description: str, frame: Frame) -> Match | None:
        """The thing that is meant; a place ("the thing at (512, 300)") takes no model.

        Raises:
            UnusableReply: The model's reply, and its second one, hold no point in the picture.
            ModelFailed: No reply came.
        """
        place = place_in(description)
        if place is None:
            point = self.point(description, frame)
        else:
            h, w = frame.depth.shape
            point = (int(place[0]), int(place[1])) if place[0] < w and place[1] < h else None
        mask = None if point is None else self._masker.mask_at(frame, point)
        return None if mask is None or not mask.any() else Match(thing_of(mask, frame))

    def point(self, description: str, frame: Frame) -> tuple[int, int] | None:
        """(u, v) of what the words mean, by the model; None if it sees nothing that fits."""
        assert frame.rgb is not None
        height, width = frame.depth.shape
        question = _QUESTION.format(
            width=width,
            height=height,
            description=json.dumps(description, ensure_ascii=False),
            convention=IN_WORDS[self._convention],
        )
        images: list[Array] = [frame.rgb]
        return asked(
            self._ask, images, question, lambda r: read_point(r, self._convention, width, height)
        )
