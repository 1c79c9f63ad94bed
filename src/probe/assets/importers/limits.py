"""Time and memory that one object may cost a worker process, whatever its files hold."""

from __future__ import annotations

import contextlib
import resource
import signal
from collections.abc import Generator
from pathlib import Path
from types import FrameType

from probe.errors import BadMesh

SECONDS = 300
MEMORY = 8 * 2**30
"""Bytes of address space of a worker; the largest mesh that we take needs a fraction of it."""


def set_limits() -> None:
    """Limit this process's memory; to be called once in each worker."""
    hard = resource.getrlimit(resource.RLIMIT_AS)[1]
    limit = MEMORY if hard == resource.RLIM_INFINITY else min(MEMORY, hard)
    resource.setrlimit(resource.RLIMIT_AS, (limit, hard))
    signal.signal(signal.SIGALRM, _too_long)


@contextlib.contextmanager
def limited(path: Path) -> Generator[None]:
    """Refuse an object that takes over five minutes or runs out of memory.

    The limit takes effect between steps of Python; only in a process that called `set_limits`.

    Raises:
        BadMesh: It did.
    """
    armed = signal.getsignal(signal.SIGALRM) is _too_long
    if armed:
        signal.alarm(SECONDS)
    try:
        yield
    except _TooLong as error:
        raise BadMesh(path, f"takes over {SECONDS} s", "Decimate it.") from error
    except MemoryError as error:
        raise BadMesh(path, "needs too much memory", "Decimate it.") from error
    finally:
        if armed:
            signal.alarm(0)


class _TooLong(Exception):
    """The alarm went off."""


def _too_long(signum: int, frame: FrameType | None) -> None:
    raise _TooLong
