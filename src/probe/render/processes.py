"""Processes that a render worker starts: forked children, and Blender."""

from __future__ import annotations

import multiprocessing
import socket
import subprocess
import sys
from collections.abc import Callable
from multiprocessing.connection import Connection

_FORK = multiprocessing.get_context("fork")


class Child:
    """A forked process that answers requests over a pipe.

    Args:
        parent: The worker's own connection to its client, which the child must not keep open.
        serve: What the child does with its end of the pipe.
    """

    def __init__(self, parent: Connection, serve: Callable[[Connection], None]) -> None:
        self.pipe, theirs = _FORK.Pipe()

        def run() -> None:
            parent.close()
            self.pipe.close()
            serve(theirs)

        self._process = _FORK.Process(target=run, daemon=True)
        self._process.start()
        theirs.close()

    def stop(self) -> None:
        self.pipe.close()
        self._process.join()


def start_module(
    module: str, *arguments: str, stderr: int | None = None
) -> tuple[subprocess.Popen[bytes], Connection]:
    """Run a module of ours in a new process; it gets the handle of a connection to us first.

    Args:
        module: What to run.
        arguments: What else it is told.
        stderr: Where its errors go, a file descriptor; None for where ours go.
    """
    ours, theirs = socket.socketpair()
    process = subprocess.Popen(
        [sys.executable, "-m", module, str(theirs.fileno()), *arguments],
        pass_fds=[theirs.fileno()],
        stdin=subprocess.DEVNULL,
        stdout=subprocess.DEVNULL,
        stderr=stderr,
    )
    theirs.close()
    return process, Connection(ours.detach())
