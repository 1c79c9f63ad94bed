"""A station whose every motion a person is shown before, and may refuse."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from uuid import uuid4

import numpy as np

from probe.errors import StoppedByPerson
from probe.station.path_picture import path_picture, tip_of
from probe.station.station import Arm, Hand, Station
from probe.types import Array, Frame

_MM = 1000.0


@dataclass(frozen=True, eq=False)
class PlannedMotion:
    """What a person is asked to approve.

    Attributes:
        number: From 1, in the order in which motions are asked for.
        words: What would move, and where to.
        picture: The newest picture of the table with the motion drawn over it, uint8, (h, w, 3).
        id: Of this motion alone: each episode counts its own.
    """

    number: int
    words: str
    picture: Array
    id: str = field(default_factory=lambda: uuid4().hex)


Over = Callable[[], bool]
"""Whether a person has stopped the robot in this episode, and be it that they released it since."""

Ask = Callable[[PlannedMotion, Over], bool]
"""Whether a person lets a motion happen; returns once they have said so, or once it is over."""


class Approved:
    """A Station that asks before each motion of the arm or the hand.

    A motion that is refused ends the episode as a fault (StoppedByPerson). To tell the skill that
    the way was blocked would be untrue: it would go on with further motions, the agent would read
    that something stood in its way, and a person's choice would be scored as the agent's. The arm
    stays where it is until a person decides.

    Args:
        station: The one that acts.
        ask: Asks a person.
        look: What a camera sees now, with colours, the arm included.
        over: Of its episode. A stop may come while a motion's picture is being made, before anybody
            is asked: no motion begins after it.
    """

    def __init__(self, station: Station, ask: Ask, look: Callable[[], Frame], over: Over) -> None:
        self.arm: Arm = station.arm
        self.hand: Hand = station.hand
        self._station = station
        self._ask = ask
        self._count = 0
        self._look = look
        self._over = over
        self._told: float | None = None

    def observe(self, *, rgb: bool) -> Frame:
        """As Station."""
        return self._station.observe(rgb=rgb)

    def look_into_basket(self, *, rgb: bool) -> Frame:
        """As Station."""
        return self._station.look_into_basket(rgb=rgb)

    def joints(self) -> Array:
        """As Station."""
        return self._station.joints()

    def follow(self, path: Array) -> bool:
        """As Station.

        Raises:
            StoppedByPerson: The motion was refused; nothing moved.
        """
        whole = np.vstack([self._station.joints(), path])
        x, y, z = tip_of(self.arm, self.hand, whole[-1])
        turn = np.degrees(np.abs(np.diff(whole, axis=0)).sum(axis=0).max())
        way = f"a joint turns {turn:.0f} degrees"
        self._approve(f"Move the hand to x {x:.2f}, y {y:.2f}, z {z:.2f} m; {way}.", whole)
        return self._station.follow(path)

    def grip(self, opening: float) -> float:
        """As Station; to ask for the opening that it was last told to take asks nobody.

        Raises:
            StoppedByPerson: The motion was refused; nothing moved.
        """
        if opening != self._told:
            words = f"Move the fingers towards an opening of {_MM * opening:.0f} mm."
            self._approve(words, self._station.joints()[None])
            self._told = opening
        return self._station.grip(opening)

    def wait(self, seconds: float) -> None:
        """As Station."""
        self._station.wait(seconds)

    def _approve(self, words: str, path: Array) -> None:
        self._count += 1
        picture = path_picture(self._look(), self.arm, self.hand, path)
        # A stop may have come while the picture was made, and while a person was asked.
        asked = PlannedMotion(self._count, words, picture)
        if self._over() or not self._ask(asked, self._over) or self._over():
            raise StoppedByPerson(f"A person refused motion {self._count}. {words}")
