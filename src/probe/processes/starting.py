"""Three ways to start a worker: spawned for jobs, forked from another worker, or as a module."""

from __future__ import annotations

import multiprocessing
import socket
import subprocess
import sys
from collections.abc import Callable
from multiprocessing.connection import Connection
from typing import TypeVar

from probe.processes.serving import Opening, serve
from probe.processes.worker_process import WorkerProcess

Job = TypeVar("Job")
Result = TypeVar("Result")

_FORK = multiprocessing.get_context("fork")
_SPAWN = multiprocessing.get_context("spawn")


def spawn(opening: Opening[Job, Result]) -> WorkerProcess:
    """Start a worker that does jobs; its first message is a WorkerReady, later ones are results.

    Args:
        opening: Sets it up; the end of a pipe may be among what it holds.
    """
    ours, theirs = _SPAWN.Pipe()
    process = _SPAWN.Process(target=serve, args=(opening, theirs), daemon=True)
    process.start()
    theirs.close()
    return WorkerProcess(process, ours)


def fork(parent: Connection, work: Callable[[Connection], None]) -> WorkerProcess:
    """Start a copy of this process, itself a worker.

    Args:
        parent: This worker's own connection to its client, which the copy must not keep open.
        work: What the copy does with its end of the pipe.
    """
    ours, theirs = _FORK.Pipe()

    def run() -> None:
        parent.close()
        ours.close()
        work(theirs)

    process = _FORK.Process(target=run, daemon=True)
    process.start()
    theirs.close()
    return WorkerProcess(process, ours)


def start_module(module: str, *arguments: str, stderr: int | None = None) -> WorkerProcess:
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
    return WorkerProcess(process, Connection(ours.detach()))
