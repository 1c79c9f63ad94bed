"""What the tools need of the manipulation skills; `probe.manipulation` is one of these."""

from __future__ import annotations

from typing import Literal, Protocol

from probe.scene.setup import Setup
from probe.station.station import Station
from probe.types import Array, Frame

Direction = Literal["up", "down", "left", "right"]


class SkillOutcome(Protocol):
    """How an attempt went."""

    @property
    def status(self) -> str:
        """One word for it."""
        ...

    @property
    def frame(self) -> Frame:
        """The table afterwards."""
        ...


class ShoveOutcome(Protocol):
    """How a push went that came before a grasp."""

    @property
    def direction(self) -> Direction:
        """Where to."""
        ...

    @property
    def moved(self) -> float | None:
        """How far the thing went that way, by its looks, metres; None if it was lost from view."""
        ...


class GraspOutcome(SkillOutcome, Protocol):
    """How a grasp went."""

    @property
    def shove(self) -> ShoveOutcome | None:
        """The push that came first; None without one."""
        ...


class PushOutcome(SkillOutcome, Protocol):
    """How a push went."""

    @property
    def moved(self) -> float | None:
        """How far the thing went the way it was pushed, by its looks, metres; None if unknown."""
        ...


class Skills(Protocol):
    """Grasping and pushing, given what a camera and a mask show."""

    def grasp_and_remove(
        self, station: Station, frame: Frame, mask: Array, setup: Setup, /
    ) -> GraspOutcome:
        """Grasp what the mask shows and let it go over the basket; it may be pushed first."""
        ...

    def push(
        self,
        station: Station,
        frame: Frame,
        mask: Array,
        direction: Direction,
        distance: float,
        setup: Setup,
        /,
    ) -> PushOutcome:
        """Push what the mask shows so many metres the picture's way, not into the basket."""
        ...
