"""What clients may ask for, each request checked field by field before anything else sees it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Callable, Dict, List, Tuple, Union

from probe_bridge.curve import Row
from probe_bridge.fields import Fields

MAX_WAYPOINTS = 2000
MAX_WAIT = 30.0
MAX_SEQ = 2**53


@dataclass(frozen=True)
class Hello:
    """First of all: which protocol the client speaks."""

    version: int


@dataclass(frozen=True)
class Observe:
    """A picture of a camera; depth always, colour on request."""

    camera: str
    rgb: bool


@dataclass(frozen=True)
class Glimpse:
    """A small colour picture without depth, for a film: every `step`-th pixel and row."""

    camera: str
    step: int


@dataclass(frozen=True)
class Follow:
    """Move through joint angles, radians.

    Attributes:
        path: Waypoints.
        speed: Share of the robot's speed limits that the motion may use, 0.01 to 1.
        seen: The robot's clock as its newest reply told it, seconds; so for all that moves it.
    """

    path: List[Row]
    speed: float
    seen: float


@dataclass(frozen=True)
class Home:
    """Move straight to the home position; fields as of Follow."""

    speed: float
    seen: float


@dataclass(frozen=True)
class Grip:
    """Move the hand towards an opening, metres."""

    opening: float
    seen: float


@dataclass(frozen=True)
class Renew:
    """Let what moves go on."""

    seen: float


@dataclass(frozen=True)
class Wait:
    """Let things come to rest for so many seconds."""

    seconds: float


@dataclass(frozen=True)
class Bare:
    """A request without arguments: joints, state or stop."""

    do: str


Request = Union[Hello, Observe, Glimpse, Follow, Home, Grip, Renew, Wait, Bare]

BARE = ("joints", "state", "stop")

SLOWEST = 0.01
"""Least share of the speed limits that a motion may ask for."""

COARSEST = 16
"""Most pixels from one that is kept of a glimpse to the next."""

_CLOCK = 1e12


def read_request(message: Dict[str, Any], joints: int) -> Tuple[int, Request]:
    """Sequence number and request of a message, for an arm of so many joints.

    Raises:
        BridgeError: "refused"; it names the field that is wrong.
    """
    fields = Fields(message, "request")
    seq = fields.whole("seq", 1, MAX_SEQ)
    do = fields.text("do")
    readers: Dict[str, Callable[[], Request]] = {
        "hello": lambda: Hello(fields.whole("version", 0, 10**6)),
        "observe": lambda: Observe(fields.text("camera"), fields.flag("rgb")),
        "glimpse": lambda: Glimpse(fields.text("camera"), fields.whole("step", 1, COARSEST)),
        "follow": lambda: Follow(
            fields.rows("path", joints, MAX_WAYPOINTS), _speed(fields), _seen(fields)
        ),
        "home": lambda: Home(_speed(fields), _seen(fields)),
        "grip": lambda: Grip(fields.number("opening", 0.0, 1.0), _seen(fields)),
        "lease": lambda: Renew(_seen(fields)),
        "wait": lambda: Wait(fields.number("seconds", 0.0, MAX_WAIT)),
    }
    if do in BARE:
        request: Request = Bare(do)
    elif do in readers:
        request = readers[do]()
    else:
        known = ", ".join(sorted([*readers, *BARE]))
        raise fields.wrong("do", f"is not one of: {known}")
    fields.end()
    return seq, request


def _speed(fields: Fields) -> float:
    return fields.number("speed", SLOWEST, 1.0)


def _seen(fields: Fields) -> float:
    return fields.number("seen", 0.0, _CLOCK)
