"""Which perception an episode had, as its record says it; the perceivers are in `perception`."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from probe.errors import ProbeError
from probe.perception.choice import Enrolled, Perceiver, segmented

PerceptionKind = Literal["oracle", "segmenter", "enrolled"]
"""oracle: Names and outlines from the simulation's labels, or from a model that points.
segmenter: Outlines from colours and depth, and no names.
enrolled: The same outlines, and names by what an operator showed beforehand."""


@dataclass(frozen=True)
class PerceptionUsed:
    """What an episode's tools saw with.

    Attributes:
        kind: See PerceptionKind.
        objects: How many objects were enrolled; 0 for the other kinds.
        enrolment: Digest of the enrolment, 12 hex digits; empty for the other kinds.
    """

    kind: PerceptionKind = "oracle"
    objects: int = 0
    enrolment: str = ""

    @property
    def label(self) -> str:
        """What differs from the usual, in a few words; empty if nothing does."""
        if self.kind == "oracle":
            return ""
        if self.kind == "segmenter":
            return "perception segmenter"
        return f"perception enrolled ({self.objects} objects, {self.enrolment})"


ORACLE_USED = PerceptionUsed()


class PerceptionDiffers(ProbeError):
    """An episode is to be played with another perception than its record is to say."""

    def __init__(self, said: PerceptionUsed, given: PerceptionUsed) -> None:
        super().__init__(
            f"The record says {said.label or 'perception oracle'}, and what is at hand is "
            f"{given.label or 'perception oracle'}. Give the same enrolment as then."
        )


def used_by(perceiver: Perceiver) -> PerceptionUsed:
    """What a record says of an episode with this perceiver."""
    if perceiver is segmented:
        return PerceptionUsed("segmenter")
    if isinstance(perceiver, Enrolled):
        known = perceiver.enrolment
        return PerceptionUsed("enrolled", len(known.objects), known.digest)
    return ORACLE_USED


def check_perception(said: PerceptionUsed, perceiver: Perceiver) -> None:
    """See that a record will say what its tools saw with.

    Raises:
        PerceptionDiffers: It wouldn't.
    """
    given = used_by(perceiver)
    if given != said:
        raise PerceptionDiffers(said, given)
