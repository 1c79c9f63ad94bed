"""One process that we started: how it ends, and what it says. Knows not what it works at."""

from __future__ import annotations

import os
import signal
import subprocess
from multiprocessing.connection import Connection, wait
from multiprocessing.process import BaseProcess

PATIENCE = 5.0
"""Seconds that a process may take to end when it has hung up, or has been asked to end."""


class WorkerSilent(Exception):
    """No more comes from a process; the message says why, in words that follow "a process"."""


class ChildProcess:
    """A process of ours, however it was started.

    Args:
        process: What was started.
        leads_session: It was started in a session of its own, which is killed with it.
    """

    def __init__(
        self, process: BaseProcess | subprocess.Popen[bytes], *, leads_session: bool = False
    ) -> None:
        self._process = process
        self._leads_session = leads_session

    @property
    def pid(self) -> int:
        """Its process id."""
        assert self._process.pid is not None
        return self._process.pid

    def exit_code(self, patience: float | None = PATIENCE) -> int | None:
        """How it ended, minus the signal's number if one killed it; None if it hasn't.

        Args:
            patience: Seconds to wait for its end; None for ever.
        """
        if isinstance(self._process, BaseProcess):
            self._process.join(patience)
            return self._process.exitcode
        try:
            return self._process.wait(patience)
        except subprocess.TimeoutExpired:
            return None

    def ask_to_end(self) -> None:
        """Send it SIGTERM."""
        if self.exit_code(0.0) is None:
            os.kill(self.pid, signal.SIGTERM)

    def end(self, patience: float | None = PATIENCE) -> None:
        """Wait for its end, and kill it if that doesn't come.

        Args:
            patience: Seconds to wait; None for ever.
        """
        if self.exit_code(patience) is None:
            self.kill()

    def kill(self) -> None:
        """End it at once, whatever it is at."""
        if self._leads_session:
            os.killpg(self.pid, signal.SIGKILL)
        else:
            self._process.kill()
        self.exit_code(None)


class WorkerProcess(ChildProcess):
    """A process at the other end of a pipe that carries what can be pickled.

    Args:
        process: What was started.
        pipe: Our end; it is closed with the process.
    """

    def __init__(self, process: BaseProcess | subprocess.Popen[bytes], pipe: Connection) -> None:
        super().__init__(process)
        self.pipe = pipe

    def send(self, message: object) -> None:
        """Say something.

        Raises:
            WorkerSilent: It doesn't listen any more.
        """
        try:
            self.pipe.send(message)
        except OSError as error:
            raise WorkerSilent(death(self.exit_code())) from error

    def receive(self, silence: float | None = None, *others: Connection) -> object:
        """The next that it says, on its pipe before any other.

        Args:
            silence: Seconds without a word after which it is taken to hang; None for ever.
            others: Further pipes on which it may speak.

        Raises:
            WorkerSilent: It has ended, or hangs.
        """
        said = wait([self.pipe, *others], silence)
        speaking = [pipe for pipe in (self.pipe, *others) if pipe in said]
        if not speaking:
            raise WorkerSilent(f"said nothing for {silence:g} seconds")
        try:
            return speaking[0].recv()
        except (EOFError, OSError) as error:
            raise WorkerSilent(death(self.exit_code())) from error

    def end(self, patience: float | None = PATIENCE) -> None:
        """Hang up, wait for its end, and kill it if that doesn't come."""
        self.pipe.close()
        super().end(patience)

    def kill(self) -> None:
        """End it at once, whatever it is at, and hang up."""
        super().kill()
        self.pipe.close()


def death(exit_code: int | None) -> str:
    """How a process ended, in words that follow "a process".

    Args:
        exit_code: See ChildProcess.exit_code.
    """
    if exit_code is None:
        return "hung up"
    if exit_code >= 0:
        return f"ended with status {exit_code}"
    return f"was killed by signal {-exit_code} ({signal.Signals(-exit_code).name})"
