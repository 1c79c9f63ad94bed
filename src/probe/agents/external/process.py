"""Our side of an agent's process: start it, ask it, end it with all that it has started."""

from __future__ import annotations

import os
import socket
import subprocess
import sys
import tempfile
import threading
from typing import IO, TypeVar

import pydantic

from probe.agents.external.protocol import (
    LONGEST_LINE,
    AgentReady,
    AgentReply,
    AgentTurn,
    Confinement,
    Opening,
)
from probe.agents.external.readable_paths import PACKAGE
from probe.agents.external.sandbox import START_SECONDS
from probe.agents.external.wire import TooLate, TooLong, Wire, WireCut
from probe.errors import WorkerDied
from probe.files import fault
from probe.processes.worker_process import PATIENCE, ChildProcess, death

PRINTED = 65_536
"""Bytes of what an agent prints in an episode that are kept."""

_MODULE = "probe.agents.external.supervisor"
_KILLED = 128

Said = TypeVar("Said", Confinement, AgentReady, AgentReply)


class AgentFailed(Exception):
    """The agent's process did what none may; the message says what, after the agent's name."""


class AgentProcess:
    """A process that holds one agent for one episode.

    Args:
        opening: Which agent, and what it is allowed.

    Raises:
        WorkerDied: It couldn't be set up, before any of the agent's code ran.
        AgentFailed: There is no agent in the file.
    """

    def __init__(self, opening: Opening) -> None:
        self._folder = tempfile.TemporaryDirectory(
            prefix="probe-agent-", ignore_cleanup_errors=True
        )
        ours, theirs = socket.socketpair()
        with theirs:
            started = _started(theirs.fileno(), self._folder.name, network=opening.network)
        self._process = ChildProcess(started, leads_session=True)
        self._wire = Wire(ours)
        assert started.stdout is not None
        self._prints = _Prints(started.stdout)
        try:
            self.confined, self.ready = self._met(opening)
        except BaseException:
            self.close()
            raise

    @property
    def pid(self) -> int:
        """Of the process that guards the agent's."""
        return self._process.pid

    def ask(self, step: AgentTurn, seconds: float) -> AgentReply:
        """What the agent does next.

        Raises:
            AgentFailed: Nothing sane came back in time.
        """
        try:
            self._wire.send(step.line, seconds)
        except WireCut as error:
            raise AgentFailed(self._death()) from error
        except TooLate as error:
            raise AgentFailed(f"didn't listen for {seconds:g} s") from error
        return self._said(AgentReply, seconds)

    def close(self) -> bytes:
        """End it and all that it has started; gives what was printed, the first part of it."""
        self._wire.close()
        self._process.ask_to_end()
        self._process.end()
        self._folder.cleanup()
        return self._prints.kept()

    def _met(self, opening: Opening) -> tuple[Confinement, AgentReady]:
        try:
            self._wire.send(opening.line, START_SECONDS)
            confined = self._said(Confinement, START_SECONDS)
        except (AgentFailed, WireCut, TooLate) as error:
            raise WorkerDied("setting up a process for an agent") from error
        ready = self._said(AgentReady, START_SECONDS)
        if ready.failed:
            raise AgentFailed(f"couldn't be made: {ready.failed}")
        return confined, ready

    def _said(self, kind: type[Said], seconds: float) -> Said:
        try:
            return kind.model_validate_json(self._wire.receive(LONGEST_LINE, seconds))
        except WireCut as error:
            raise AgentFailed(self._death()) from error
        except TooLate as error:
            raise AgentFailed(f"gave no reply within {seconds:g} s") from error
        except TooLong as error:
            raise AgentFailed(f"sent more than {LONGEST_LINE} bytes at once") from error
        except pydantic.ValidationError as error:
            raise AgentFailed(f"sent what is no reply ({fault(error, 'all of it')})") from error

    def _death(self) -> str:
        """How the process ended, which has hung up."""
        status = self._process.exit_code()
        if status is None or status < 0:
            return death(status)
        if status > _KILLED:
            return death(_KILLED - status)
        return f"ended its process with status {status}"


class _Prints:
    """Reads what a process prints to its end, and keeps the first part."""

    def __init__(self, source: IO[bytes]) -> None:
        self._source = source
        self._first = bytearray()
        self._reader = threading.Thread(target=self._read, daemon=True)
        self._reader.start()

    def kept(self) -> bytes:
        """What there is when it has ended."""
        self._reader.join(PATIENCE)
        return bytes(self._first)

    def _read(self) -> None:
        with self._source:
            while piece := os.read(self._source.fileno(), PRINTED):
                self._first += piece[: PRINTED - len(self._first)]


def _started(handle: int, folder: str, *, network: bool) -> subprocess.Popen[bytes]:
    """A fresh interpreter with nothing of ours but the socket.

    Not "-I": it would take the order of sets from chance. What that keeps out isn't there anyway:
    the environment is new, the folder empty.
    """
    threads = {name: value for name, value in os.environ.items() if name.endswith("_NUM_THREADS")}
    return subprocess.Popen(
        [sys.executable, "-P", "-s", "-u", "-m", _MODULE, str(handle), str(int(network))],
        pass_fds=[handle],
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        cwd=folder,
        start_new_session=True,
        env={
            "HOME": folder,
            "LANG": "C.UTF-8",
            "PATH": "/usr/bin:/bin",
            "PYTHONHASHSEED": "0",
            "PYTHONPATH": str(PACKAGE.parent),
            "TMPDIR": folder,
            **threads,
        },
    )
