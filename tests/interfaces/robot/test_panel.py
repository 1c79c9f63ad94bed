"""A person at a robot's page: a stop in the middle of a motion, and motions that wait for a yes."""

from __future__ import annotations

import io
import json
import threading
import time
import urllib.request
from collections.abc import Callable, Generator
from contextlib import contextmanager
from http.client import HTTPResponse
from pathlib import Path
from typing import Any
from urllib.error import HTTPError

import numpy as np
import pytest
from PIL import Image

from probe.errors import StoppedByPerson
from probe.interfaces.robot.app import RobotPanel
from probe.interfaces.robot.desk import QUICKEST, ApprovalDesk
from probe.interfaces.robot.server import panel_page
from probe.station.approved import Approved
from probe.station.emergency_stop import EmergencyStop
from probe.station.station import Station
from probe.station.stoppable import Stoppable
from probe.types import Frame
from station.test_approved import AWAY
from station.test_remote import FILE, PARKED, _speeds, station

FAR = np.array([PARKED + (1.0, 0, 0, 0, 0, 0)])


class Page:
    def __init__(self, address: str) -> None:
        self.address = address

    def post(self, path: str, said: object, **headers: str) -> dict[str, Any]:
        data = json.dumps(said).encode()
        about = {"content-type": "application/json", **headers}
        with self._open(path, data, about) as reply:
            return json.load(reply)

    def look(self, path: str) -> bytes:
        with self._open(path, None, {}) as reply:
            return reply.read()

    def state(self) -> dict[str, Any]:
        return json.loads(self.look("state"))

    def _open(self, path: str, data: bytes | None, about: dict[str, str]) -> HTTPResponse:
        request = urllib.request.Request(self.address + path, data, about)
        return urllib.request.urlopen(request, timeout=10)


@contextmanager
def watched(
    folder: Path, raw: Any = FILE, look: Callable[[], Frame] | None = None
) -> Generator[tuple[Callable[[], Station], Page, Any, list[str]]]:
    """What gives an episode its station behind a page, the bridge, and notes of answers."""
    notes: list[str] = []
    with station(raw) as (robot, bridge):
        desk = ApprovalDesk(folder, lambda *_: None, lambda it, yes: notes.append(
            f"{it.number} {yes}"))  # fmt: skip
        stop = EmergencyStop([desk.refuse, robot.stop], robot.release)

        def episode() -> Station:
            pressed = stop.presses
            over = lambda: stop.presses != pressed  # noqa: E731 - it is one condition
            return Stoppable(Approved(robot, desk.ask, look or robot.glance, over), stop)

        with panel_page(RobotPanel(stop, desk, robot.glance), 0) as address:
            yield episode, Page(address), bridge, notes


class Moving(threading.Thread):
    """A motion in a thread of its own, and what came of it."""

    def __init__(self, acting: Station, path: Any) -> None:
        super().__init__()
        self.acting, self.path = acting, path
        self.came: object = None
        self.start()

    def run(self) -> None:
        try:
            self.came = self.acting.follow(self.path)
        except Exception as error:
            self.came = error

    def begun(self, bridge: Any) -> None:
        """Wait until the arm moves."""
        while not bridge.driver.moves:
            assert self.is_alive(), f"it came to nothing: {self.came}"
            time.sleep(0.01)


def shown(page: Page) -> int:
    """The id of the motion that waits, once it may be answered."""
    until = time.monotonic() + 30
    while page.state()["waiting"] is None:
        assert time.monotonic() < until, "no motion waits"
        time.sleep(0.02)
    time.sleep(QUICKEST)
    return page.state()["waiting"]["id"]


def test_a_motion_waits_for_its_yes_with_its_picture(tmp_path: Path) -> None:
    with watched(tmp_path) as (episode, page, bridge, notes):
        acting = episode()
        moving = Moving(acting, np.array([AWAY]))
        motion = shown(page)
        assert not bridge.driver.moves
        assert "Move the hand to x" in page.state()["waiting"]["words"]
        with Image.open(io.BytesIO(page.look(f"motion.jpg?{motion}"))) as image:
            assert image.size == (1024, 1024)
        assert page.post("answer", {"motion": motion, "yes": True})["stopped"] is None
        moving.join()
        assert moving.came is True and np.allclose(acting.joints(), AWAY, atol=1e-6)
        assert notes == ["1 True"] and (tmp_path / "motions" / "0001.jpg").exists()
        with pytest.raises(HTTPError, match="409"):
            page.post("answer", {"motion": motion, "yes": True})


def test_a_no_ends_it_and_a_yes_before_anybody_could_look_counts_for_nothing(tmp_path) -> None:
    with watched(tmp_path) as (episode, page, bridge, notes):
        acting = episode()
        moving = Moving(acting, np.array([AWAY]))
        while page.state()["waiting"] is None:
            time.sleep(0.01)
        motion = page.state()["waiting"]["id"]
        with pytest.raises(HTTPError, match="409"):
            page.post("answer", {"motion": motion, "yes": True})
        page.post("answer", {"motion": motion, "yes": False})
        moving.join()
        assert isinstance(moving.came, StoppedByPerson) and "refused motion 1" in str(moving.came)
        assert not bridge.driver.moves and notes == ["1 False"]


def test_the_button_stops_a_motion_and_nothing_moves_until_the_release(tmp_path: Path) -> None:
    with watched(tmp_path, {**FILE, **_speeds(0.3)}) as (episode, page, bridge, _):
        acting = episode()
        moving = Moving(acting, FAR)
        page.post("answer", {"motion": shown(page), "yes": True})
        moving.begun(bridge)
        time.sleep(0.3)
        pressed = time.monotonic()
        assert page.post("stop", {})["stopped"] == "the page"
        assert bridge.driver.stops[0] - pressed < 0.5
        moving.join()
        assert isinstance(moving.came, StoppedByPerson) and "by the page" in str(moving.came)
        rest = bridge.driver.joints().joints
        assert PARKED[0] < rest[0] < FAR[0][0]
        with pytest.raises(StoppedByPerson):
            acting.grip(0.0)
        assert page.post("release", {})["stopped"] is None
        assert bridge.driver.joints().joints == rest
        with pytest.raises(StoppedByPerson, match="in this episode, and released it"):
            acting.grip(0.0)
        back = Moving(episode(), np.array([PARKED]))
        page.post("answer", {"motion": shown(page), "yes": True})
        back.join()
        assert back.came is True


def test_a_stop_while_a_motion_waits_says_no_to_it(tmp_path: Path) -> None:
    with watched(tmp_path) as (episode, page, bridge, notes):
        acting = episode()
        moving = Moving(acting, FAR)
        shown(page)
        page.post("stop", {})
        moving.join()
        assert isinstance(moving.came, StoppedByPerson) and "by the page" in str(moving.came)
        assert not bridge.driver.moves and notes == ["1 False"]


def test_a_stop_before_anybody_was_asked_ends_the_episode_and_a_release_lets_no_motion_begin(
    tmp_path: Path,
) -> None:
    """It comes while the motion's picture is being made."""
    seen, pressed = threading.Event(), threading.Event()
    with watched(tmp_path, look=lambda: looked()) as (episode, page, bridge, notes):
        frame = episode().observe(rgb=True)

        def looked() -> Frame:
            seen.set()
            assert pressed.wait(30)
            return frame

        moving = Moving(episode(), FAR)
        assert seen.wait(30)
        page.post("stop", {})
        page.post("release", {})
        pressed.set()
        moving.join(30)
        assert isinstance(moving.came, StoppedByPerson)
        assert not bridge.driver.moves and not notes  # Nobody is asked any more.


def test_answers_are_to_one_motion_though_each_episode_counts_from_one(tmp_path: Path) -> None:
    with watched(tmp_path) as (episode, page, bridge, _):
        first = Moving(episode(), np.array([AWAY]))
        earlier = shown(page)
        page.post("answer", {"motion": earlier, "yes": False})
        assert page.state()["waiting"] is None
        first.join()
        second = Moving(episode(), np.array([AWAY]))
        assert shown(page) != earlier and page.state()["waiting"]["number"] == 1
        with pytest.raises(HTTPError, match="409"):
            page.post("answer", {"motion": earlier, "yes": True})
        page.post("answer", {"motion": shown(page), "yes": False})
        second.join()
        assert not bridge.driver.moves


def test_the_page_shows_the_table_and_heeds_its_own_requests_alone(tmp_path: Path) -> None:
    with watched(tmp_path) as (_, page, _, _):
        with Image.open(io.BytesIO(page.look("live.jpg"))) as image:
            assert image.size == (1024, 1024)
        assert b'id="stop"' in page.look("") and b"STOP" in page.look("")
        for name in ("static/panel.js", "static/panel.css", "base.css"):
            assert page.look(name)
        with pytest.raises(HTTPError, match="403"):
            page.post("release", {}, origin="http://elsewhere.example")
        with pytest.raises(HTTPError, match="415"):
            page.post("answer", {}, **{"content-type": "text/plain"})
        with pytest.raises(HTTPError, match="400"):
            page.post("answer", {"motion": "1"})
        with pytest.raises(HTTPError, match="400"):
            page.post("stop", {}, host="elsewhere.example")
