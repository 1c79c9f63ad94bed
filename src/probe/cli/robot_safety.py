"""How a person watches over a robot: approval of motions, slow ones at first, a stop."""

from __future__ import annotations

from collections.abc import Generator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

import numpy as np

from probe.cli.robot_keys import keys
from probe.cli.screen import say, warn
from probe.errors import MissingExtra, RobotLost
from probe.interfaces.robot.desk import ApprovalDesk
from probe.station.approved import Approved, PlannedMotion
from probe.station.emergency_stop import EmergencyStop
from probe.station.remote import PARKED, RobotStation
from probe.station.station import Station
from probe.station.stoppable import Stoppable

COMMANDS = "commands.jsonl"
"""Log beside a run's records of all that was commanded."""

PAGE = 8138


@dataclass(frozen=True)
class SafetyChoice:
    """How a person watches over the robot.

    Attributes:
        approve: Whether each motion waits for a person's yes, in the terminal or on the page, or
            happens at once.
        slow_motions: How many of the arm's first motions go at a quarter of its speed limits.
        page_port: Where this machine's browser finds the page with the stop; 0 for any free port.
    """

    approve: Literal["ask", "auto"] = "ask"
    slow_motions: int = 4
    page_port: int = PAGE

    @property
    def numbers(self) -> dict[str, int]:
        """The options that have to be numbers from 0 on."""
        return {"--slow-motions": self.slow_motions, "--page-port": self.page_port}


@contextmanager
def guarded(robot: RobotStation, choice: SafetyChoice, out: Path) -> Generator[Station]:
    """A robot that a person can stop by any key and by a page, as long as the block lasts.

    An arm that an earlier episode left on its way is brought home first, with the same approval.

    Args:
        robot: Whom to watch over.
        choice: How.
        out: Folder of the run; pictures of planned motions are kept in it.

    Raises:
        MissingExtra: The page's packages aren't installed.
        StoppedByPerson: A person didn't let the arm be brought home.
    """
    try:
        from probe.interfaces.robot.app import RobotPanel
        from probe.interfaces.robot.server import panel_page
    except ImportError as error:
        raise MissingExtra("The page that stops a robot", "human") from error
    desk = ApprovalDesk(out, _tell, lambda motion, yes: _note(robot, motion, yes=yes))
    stop = EmergencyStop([desk.refuse, robot.stop, lambda: robot.note("stopped by a person")],
                         robot.release)  # fmt: skip
    asks = choice.approve == "ask"
    panel = RobotPanel(stop, desk if asks else None, robot.glance)
    acting = Approved(robot, desk.ask, robot.glance, lambda: stop.presses > 0) if asks else robot
    station = Stoppable(acting, stop)
    with panel_page(panel, choice.page_port) as address, keys(lambda key: heard(key, stop, desk)):
        say(f"Any key stops the robot, and so does {address}")
        if np.abs(robot.joints() - robot.arm.parked).max() > PARKED:
            say("The arm isn't home; it is brought there first.")
            station.follow(robot.arm.parked[None])
        yield station


def heard(key: str, stop: EmergencyStop, desk: ApprovalDesk) -> None:
    """What a key does: y and n answer a motion that waits, r releases, any other one stops."""
    waiting = desk.waiting
    if waiting is not None and key in "yYnN":
        desk.answer(waiting.id, yes=key in "yY")
    elif stop.by is not None:
        if key in "rR":
            stop.release()
            say("The robot may move again.")
    else:
        try:
            stop.press("a key")
        except RobotLost as error:
            warn(error)
        say("STOPPED. The arm stays where it is, and the episode ends. r lets it move again.")


def _tell(motion: PlannedMotion, picture: Path) -> None:
    say(f"Motion {motion.number}. {motion.words} What is in view is drawn in {picture}")
    say("May it? y: yes, n: no, which ends the episode. Any other key stops the robot.")


def _note(robot: RobotStation, motion: PlannedMotion, *, yes: bool) -> None:
    answer = "approved" if yes else "refused by a person"
    robot.note(answer, motion=motion.number, words=motion.words)
