"""Keys in the terminal: any of them stops, y and n answer, r releases."""

from __future__ import annotations

import os
import pty
import threading
import time
from collections.abc import Iterator
from contextlib import closing
from pathlib import Path

import numpy as np
import pytest

from probe.cli.robot_keys import keys
from probe.cli.robot_safety import SafetyChoice, guarded
from probe.errors import StoppedByPerson
from probe.interfaces.robot.desk import QUICKEST
from station.test_approved import AWAY
from station.test_remote import FILE, PARKED, _speeds, station


class Terminal:
    """A terminal with a keyboard, in place of standard input."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch) -> None:
        self._board, there = pty.openpty()
        self._input = os.fdopen(there)
        monkeypatch.setattr("sys.stdin", self._input)

    def press(self, key: str) -> None:
        os.write(self._board, key.encode())

    def close(self) -> None:
        self._input.close()
        os.close(self._board)


@pytest.fixture
def terminal(monkeypatch: pytest.MonkeyPatch) -> Iterator[Terminal]:
    with closing(Terminal(monkeypatch)) as opened:
        yield opened


def test_single_keys_are_heard_at_once_and_the_terminal_is_as_before(terminal) -> None:
    heard: list[str] = []
    terminal.press("x")  # typed before anybody asked
    time.sleep(0.05)
    with keys(heard.append):
        for key in "y \n":
            terminal.press(key)
            time.sleep(0.1)
    assert heard == ["y", " ", "\n"]


def test_lines_are_heard_where_there_is_no_terminal(monkeypatch: pytest.MonkeyPatch) -> None:
    out, into = os.pipe()
    heard: list[str] = []
    with os.fdopen(out) as lines, monkeypatch.context() as patched:
        patched.setattr("sys.stdin", lines)
        with keys(heard.append):
            os.write(into, b"yes\n\nno")
            time.sleep(0.2)
            os.close(into)
    assert heard == ["y", "\n"]


@pytest.mark.slow
def test_y_lets_a_motion_happen_and_any_other_key_stops_it(
    terminal: Terminal, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    with station({**FILE, **_speeds(0.3)}) as (robot, bridge):
        with guarded(robot, SafetyChoice(page_port=0), tmp_path) as acting:
            pressing(terminal, tmp_path, 1, "y")
            assert acting.follow(np.array([PARKED + (0.05, 0, 0, 0, 0, 0)]))
            pressing(terminal, tmp_path, 2, "y", " ")
            with pytest.raises(StoppedByPerson, match="by a key"):
                acting.follow(np.array([PARKED + (1.0, 0, 0, 0, 0, 0)]))
            assert bridge.driver.stops and robot.joints()[0] < PARKED[0] + 0.9
            with pytest.raises(StoppedByPerson, match="by a key"):
                acting.joints()
            said = capsys.readouterr().out
            assert "STOPPED" in said
            terminal.press("r")
            until = time.monotonic() + 30
            while "may move again" not in said:
                assert time.monotonic() < until, "r released nothing"
                time.sleep(0.05)
                said += capsys.readouterr().out
            with pytest.raises(StoppedByPerson, match="in this episode, and released it"):
                acting.joints()
        pressing(terminal, tmp_path / "next", 1, "n")
        with (
            pytest.raises(StoppedByPerson, match="refused motion 1"),
            guarded(robot, SafetyChoice(page_port=0), tmp_path / "next"),
        ):
            pass
    assert len(list((tmp_path / "motions").glob("*.jpg"))) == 2


def test_an_arm_that_is_on_its_way_is_brought_home_first(
    terminal: Terminal, tmp_path: Path
) -> None:
    with station() as (robot, _):
        robot.follow(np.array([AWAY]))
        pressing(terminal, tmp_path, 1, "n")
        with (
            pytest.raises(StoppedByPerson, match="refused motion 1"),
            guarded(robot, SafetyChoice(page_port=0), tmp_path),
        ):
            pass
        with guarded(robot, SafetyChoice("auto", page_port=0), tmp_path) as acting:
            assert np.allclose(acting.joints(), PARKED, atol=1e-6)


def pressing(terminal: Terminal, folder: Path, motion: int, *pressed: str) -> None:
    """Press keys in turn once that motion's picture is there, that is, once it waits."""

    def press() -> None:
        while not (folder / "motions" / f"{motion:04d}.jpg").exists():
            time.sleep(0.02)
        for key in pressed:
            time.sleep(QUICKEST + 0.5)
            terminal.press(key)

    threading.Thread(target=press).start()
