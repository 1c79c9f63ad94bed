"""All checks of a robot in their order: the bridge's own, then those with a known box."""

from __future__ import annotations

from collections.abc import Callable, Generator
from contextlib import closing, contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from probe.errors import BadData, MissingExtra, ProbeError, RobotLost
from probe.robot_check.box import KnownBox
from probe.robot_check.calibration import FEWEST, Calibration, calibrated
from probe.robot_check.corrected import corrected, write_cameras
from probe.robot_check.errors import Impossible
from probe.robot_check.holding import Cell, held_up, sightings
from probe.robot_check.outcomes import (
    BOX,
    PICK,
    REACH,
    camera_outcome,
    impossible,
    reach_outcome,
    unseen,
)
from probe.robot_check.pick import pick
from probe.scene.cameras import View
from probe.scene.setup import Setup
from probe.station.remote import RobotStation

if TYPE_CHECKING:
    from probe_bridge.checks.kit import Kit
    from probe_bridge.checks.outcome import Outcome

_VIEWS: tuple[View, ...] = ("front", "top")

MOTIONS = (
    "The robot will move: straight to its home position, each joint by 3 degrees, the hand to and"
    " fro by 10 degrees where it is, and the empty hand open and shut. Keep a hand on the emergency"
    " stop, and the arm's surroundings free."
)
CARRYING = (
    "Now clear the table and stand a plain box of {size} cm upright in its middle, its sides along"
    " the table's. The arm will take it, hold it up at about ten places, drop it into the basket,"
    " and go to the same places without it."
)
PICKING = "Now stand the box anywhere in the work area. The arm will put it into the basket."


@dataclass(frozen=True)
class Wishes:
    """What is to be checked.

    Attributes:
        setup: The table as it was measured.
        box: The known box.
        pick: Whether to try a pick.
        corrected: File for cameras with corrected poses; None for none.
    """

    setup: Setup
    box: KnownBox
    pick: bool = False
    corrected: Path | None = None


def kit_of(
    address: str, token: str, certificate: Path | None, tell: Callable[[Outcome], None]
) -> Kit:
    """The bridge's checks of a robot; `tell` hears each outcome.

    Raises:
        MissingExtra: probe-bridge isn't installed.
    """
    try:
        from probe_bridge.checks.kit import Kit
    except ImportError as error:
        raise MissingExtra("A robot", "robot", "./bridge") from error
    return Kit(address, token, certificate, tell)


def check(kit: Kit, wishes: Wishes, ask: Callable[[str], bool]) -> None:
    """Make all checks; what they find is in the kit's outcomes.

    Args:
        kit: Of the robot.
        wishes: What is to be checked.
        ask: Tells a person what comes next, and returns whether it may.
    """
    if kit.reach():
        kit.see_and_move(ask(MOTIONS))
    later = [BOX, REACH, PICK]
    if not kit.well:
        kit.skip(later, "what comes before it has failed")
    elif any(outcome.verdict == "skipped" for outcome in kit.outcomes):
        kit.skip(later, "nothing may move")
    else:
        _with_box(kit, wishes, ask)


def _with_box(kit: Kit, wishes: Wishes, ask: Callable[[str], bool]) -> None:
    with closing(kit.connect()) as client:
        views: list[View] = [view for view in _VIEWS if view in client.description.cameras]
        fit = list[RobotStation]()
        with _told(kit, REACH):
            station = RobotStation(client, wishes.setup, views[0] if views else "front")
            kit.add(reach_outcome(station, wishes.setup, client.description.joints))
            fit.append(station)
        if not fit:
            kit.skip([BOX, PICK], "what comes before it has failed")
            return
        (station,) = fit
        with _told(kit, BOX):
            size = " x ".join(f"{100 * edge:g}" for edge in wishes.box.size)
            if ask(CARRYING.format(size=size)):
                cell = Cell(client, station, wishes.setup, views, wishes.box)
                _look_at_box(kit, cell, wishes)
            else:
                kit.skip([BOX], "nobody wanted it")
        with _told(kit, PICK):
            _pick(kit, station, wishes, ask)


@contextmanager
def _told(kit: Kit, check: str) -> Generator[None]:
    """The block, whose errors are a failure of its check: what was found before isn't lost."""
    from probe_bridge.errors import BridgeError

    try:
        yield
    except Impossible as reason:
        kit.add(impossible(check, reason))
    except BadData as error:
        kit.add(impossible(check, Impossible("wrong set-up", str(error), "")))
    except (RobotLost, BridgeError) as error:
        kit.add(impossible(check, Impossible("link lost", str(error), "")))
    except ProbeError as error:
        kit.add(impossible(check, Impossible("ended early", str(error), "")))


def _look_at_box(kit: Kit, cell: Cell, wishes: Wishes) -> None:
    found: list[Calibration] = []
    for view, shown in held_up(cell).items():
        seen = sightings(shown)
        if len(seen) < FEWEST:
            kit.add(unseen(view, len(seen)))
            continue
        found.append(calibrated(seen, cell.box, wishes.setup.mount.base))
        kit.add(camera_outcome(found[-1]))
    if wishes.corrected:
        write_cameras(wishes.corrected, corrected(cell.client.description.cameras, found))


def _pick(kit: Kit, station: RobotStation, wishes: Wishes, ask: Callable[[str], bool]) -> None:
    if not wishes.pick:
        kit.skip([PICK], "say --pick to try one")
    elif not kit.well:
        kit.skip([PICK], "what comes before it has failed")
    elif not ask(PICKING):
        kit.skip([PICK], "nobody wanted it")
    else:
        kit.add(pick(station, wishes.setup))
