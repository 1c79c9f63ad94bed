"""Arms that don't do what they are told are stopped, and the reply says why."""

from __future__ import annotations

import time
from contextlib import contextmanager
from typing import Generator, Iterator, Tuple, Type

import pytest

from bridges import RememberingDriver, practice
from busy import Machine
from probe_bridge.config_file import read_config
from probe_bridge.driver import Reading
from probe_bridge.errors import BridgeError
from probe_bridge.lease import Lease
from probe_bridge.mover import TICK, Mover

CONFIG = read_config(practice())
GOAL = (*CONFIG.home[:5], CONFIG.home[5] + 1.0)


class Stuck(RememberingDriver):
    """Its last joint stops after 0.3 rad."""

    def joints(self) -> Reading:
        reading = super().joints()
        return reading._replace(joints=(*reading.joints[:5], min(reading.joints[5], 0.3)))


class Frozen(RememberingDriver):
    """Its angles are no longer measured."""

    def joints(self) -> Reading:
        return super().joints()._replace(stamp=time.monotonic() - 60.0)


class Wandering(RememberingDriver):
    """It is soon somewhere else, below the table."""

    def joints(self) -> Reading:
        reading = super().joints()
        lift = reading.joints[1] + (2.0 if reading.joints[5] > 0.1 else 0.0)
        return reading._replace(joints=(reading.joints[0], lift, *reading.joints[2:]))


class Unreachable(RememberingDriver):
    """Its controller has gone."""

    def poll(self) -> bool:
        raise ConnectionResetError("no controller")


class Endless(RememberingDriver):
    """It never says that it has arrived."""

    def poll(self) -> bool:
        super().poll()
        return False


class Short(RememberingDriver):
    """It says that it has arrived although it has not moved."""

    def poll(self) -> bool:
        return True

    def joints(self) -> Reading:
        return Reading(CONFIG.home, time.monotonic())


@pytest.fixture(autouse=True)
def quick_deadline(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("probe_bridge.watching.LATE", 0.3)


class Forever(Lease):
    """It never lapses."""

    @property
    def left(self) -> float:
        return 1.0


@contextmanager
def mover_of(driver: RememberingDriver) -> Generator[Mover, None, None]:
    mover = Mover(driver, CONFIG)
    mover.claim(time.monotonic())
    yield mover
    mover.close()


def cases() -> Iterator[Tuple[Type[RememberingDriver], str, str]]:
    yield Stuck, "blocked", "wrist_3_joint"
    yield Frozen, "fault", "old"
    yield Wandering, "outside", "outside its box"
    yield Unreachable, "fault", "no controller"
    yield Endless, "blocked", "arrive"
    yield Short, "blocked", "wrist_3_joint"


@pytest.mark.parametrize(("arm", "kind", "text"), list(cases()))
def test_stopped_with_the_reason(
    arm: Type[RememberingDriver], kind: str, text: str, monkeypatch: pytest.MonkeyPatch
):
    monkeypatch.setattr("probe_bridge.mover.Lease", Forever)
    driver = arm(CONFIG)
    with mover_of(driver) as mover:
        with pytest.raises(BridgeError, match=text) as error:
            mover.follow([CONFIG.home, GOAL], 1.0)
        assert error.value.kind == kind
        assert driver.stops
        assert not mover.busy


class Lagging(RememberingDriver):
    """It does everything 0.1 s late."""

    def joints(self) -> Reading:
        now = time.monotonic()
        if not self.moves:
            return Reading(CONFIG.home, now)
        motion, started = self.moves[-1]
        return Reading(motion.at(now - started - 0.1)[0], now)

    def poll(self) -> bool:
        motion, started = self.moves[-1]
        return time.monotonic() - started > motion.duration + 0.1


def test_an_arm_that_lags_a_little_is_not_stopped(monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr("probe_bridge.mover.Lease", Forever)
    driver = Lagging(CONFIG)
    with mover_of(driver) as mover:
        assert mover.follow([CONFIG.home, GOAL], 1.0) == pytest.approx(GOAL)
        assert not driver.stops


class Hanging(RememberingDriver):
    """It doesn't answer for two seconds."""

    def poll(self) -> bool:
        time.sleep(2.0)
        return super().poll()


def test_the_lease_counts_even_while_the_driver_hangs(machine: Machine):
    driver = Hanging(CONFIG)
    with mover_of(driver) as mover:
        with pytest.raises(BridgeError) as error:
            mover.follow([CONFIG.home, GOAL], 1.0)
        assert error.value.kind == "lease"
        assert driver.stops[0] - mover._lease._until < TICK + machine.late


class Unstoppable(RememberingDriver):
    """Its controller hears only the third call."""

    def stop(self) -> None:
        super().stop()
        if len(self.stops) < 3:
            raise ConnectionResetError("no controller")


def test_a_stop_that_fails_is_tried_again():
    driver = Unstoppable(CONFIG)
    with mover_of(driver) as mover:
        with pytest.raises(BridgeError) as error:
            mover.follow([CONFIG.home, (*CONFIG.home[:5], 3.0)], 1.0)
        assert error.value.kind == "lease"
        assert len(driver.stops) >= 3
