"""All checks of this wheel, in the order in which one may trust the next."""

from __future__ import annotations

from contextlib import ExitStack
from pathlib import Path
from typing import Callable, List, Optional, Sequence

from probe_bridge.checks.clock import CLOCK, ClockWatch
from probe_bridge.checks.frames import check_frames
from probe_bridge.checks.hand import HAND, check_hand
from probe_bridge.checks.joints import JOINTS, check_joints
from probe_bridge.checks.linked import HELLO, check_token, check_version
from probe_bridge.checks.messages import MESSAGES, check_messages
from probe_bridge.checks.outcome import FAILED, Outcome, failed, passed, skipped
from probe_bridge.checks.stopping import CUT, STOP, WATCHDOG, check_cut, check_stop, check_watchdog
from probe_bridge.client import RobotClient
from probe_bridge.errors import BridgeError

HOME, HOME_AGAIN = "home", "home again"
Told = Callable[[Outcome], None]


class Kit:
    """Runs the checks one after another and tells each outcome as it comes.

    Args:
        address: ws://HOST:PORT, or wss://HOST:PORT with TLS.
        token: The bridge's.
        certificate: Of the bridge, if no public authority vouches for it.
        tell: Hears each outcome.
    """

    def __init__(self, address: str, token: str, certificate: Optional[Path], tell: Told) -> None:
        self._where = (address, token, certificate)
        self._tell = tell
        self._clock = ClockWatch()
        self.outcomes: List[Outcome] = []

    @property
    def well(self) -> bool:
        """Whether nothing has failed so far."""
        return all(outcome.verdict != FAILED for outcome in self.outcomes)

    def add(self, outcome: Outcome) -> bool:
        """Keep and tell an outcome; returns whether it didn't fail."""
        self.outcomes.append(outcome)
        self._tell(outcome)
        return outcome.verdict != FAILED

    def reach(self) -> bool:
        """Check all that moves nothing and sees nothing; returns whether the rest can follow."""
        steps = (
            lambda: check_token(*self._where),
            lambda: check_version(*self._where),
            lambda: check_messages(*self._where, self._clock),
        )
        for number, check in enumerate(steps):
            if not self.add(check()):
                names = [HELLO, MESSAGES][number:]
                self.skip(names, "what it needs has failed")
                return False
        return True

    def connect(self) -> RobotClient:
        """A client; close it when done."""
        return RobotClient(*self._where)

    def skip(self, names: Sequence[str], reason: str) -> None:
        """Say of checks that they aren't made."""
        for name in names:
            self.add(skipped(name, f"Not made: {reason}."))

    def see_and_move(self, motions: bool) -> None:
        """Check pictures, then, if they may, what moves; last the clock that ran all the time."""
        with ExitStack() as stack:
            client = self.connect()
            stack.callback(lambda: client.close())
            for camera in client.description.cameras:
                self._made(
                    f"frames of {camera}", lambda c=camera: check_frames(client, self._clock, c)
                )
            if motions:
                client = self._moved(client)
            else:
                self.skip([HOME, JOINTS, STOP, WATCHDOG, CUT, HAND], "nothing may move")
            self._made(CLOCK, self._clock.outcome)

    def _moved(self, client: RobotClient) -> RobotClient:
        """What moves, the smallest motions first; nothing more once one of them goes wrong."""
        steps = [
            (HOME, lambda: _check_home(client, HOME)),
            (JOINTS, lambda: check_joints(client)),
            (STOP, lambda: check_stop(client)),
            (WATCHDOG, lambda: check_watchdog(client)),
            (HAND, lambda: check_hand(client)),
        ]
        for number, (name, check) in enumerate(steps):
            self._clock.look(client)
            if not self._made(name, check):
                left = [later for later, _ in steps[number + 1 :]]
                self.skip([*left, CUT], f"{name} failed, and nothing more is moved")
                return client
            self._clock.look(client)
        try:
            outcome, client = check_cut(client, self.connect)
        except BridgeError as error:
            self.add(_broken(CUT, error))
            return client
        self.add(outcome)
        self._made(HOME_AGAIN, lambda: _check_home(client, HOME_AGAIN))
        return client

    def _made(self, name: str, check: Callable[[], Outcome]) -> bool:
        """Make a check; what breaks it is its outcome."""
        try:
            return self.add(check())
        except BridgeError as error:
            return self.add(_broken(name, error))


def _broken(check: str, error: BridgeError) -> Outcome:
    """What a check found that was broken off."""
    fault = "link lost" if error.kind == "lost" else error.kind
    return failed(check, fault, error.text, error.remedy or "Look at the bridge's log.")


def _check_home(client: RobotClient, name: str) -> Outcome:
    client.home()
    return passed(name, "The arm is at its home position.")
