"""Jobs for worker processes, which have to be able to import them, and do so quickly."""

from __future__ import annotations

import json
import os
import signal
import time
from collections.abc import Callable, Generator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from probe.errors import OutputFailed, ProbeError

SLOW = {"long": 60, "slow": 20}
"""Jobs that take so many seconds."""


@dataclass(frozen=True)
class Bench:
    """A workplace whose jobs are words: what to do, and with which file.

    Attributes:
        notes: Folder in which each begun job leaves a file with its process's id.
        unfit: It can't be set up.
        stillborn: It dies while it is set up.
        frail: It dies while it is set up, but on the first of a cluster's nodes.
    """

    notes: Path
    unfit: bool = False
    stillborn: bool = False
    frail: bool = False

    @contextmanager
    def __call__(self) -> Generator[Callable[[str], bytes]]:
        if self.unfit:
            raise ProbeError("no tools here")
        if self.stillborn or (self.frail and not _on_the_first_node()):
            os.kill(os.getpid(), signal.SIGKILL)
        yield self.do
        (self.notes / f"closed-{os.getpid()}").touch()

    def do(self, job: str) -> bytes:
        """Note that the job was begun, then do it."""
        begun = self.notes / f"begun-{job}"
        earlier = begun.read_text().split() if begun.exists() else []
        begun.write_text(" ".join([*earlier, str(os.getpid())]))
        if job == "deadly" or (job == "unlucky" and not earlier):
            os.kill(os.getpid(), signal.SIGKILL)
        if job == "leaving":
            os._exit(3)
        if job.startswith("roomy") and not _on_the_first_node():
            raise OutputFailed("/cache/x.npz", "No space left on device")
        if job.startswith(("second", "roomy")):
            time.sleep(1)
        if job in SLOW:
            time.sleep(SLOW[job])
        return f"{job} done".encode()


def _on_the_first_node() -> bool:
    return "cache-1" in os.environ.get("XDG_CACHE_HOME", "")


@dataclass(frozen=True)
class AssetReader:
    """A workplace that says where its machine has assets, and what is in them.

    Attributes:
        until: No job ends before this file is there; None for none.
    """

    until: Path | None = None

    @contextmanager
    def __call__(self) -> Generator[Callable[[str], bytes]]:
        yield self.read

    def read(self, job: str) -> bytes:
        """Every file's text, after a while, so that each node gets some of the jobs."""
        time.sleep(0.5)
        end = time.monotonic() + 120
        while self.until is not None and not self.until.exists() and time.monotonic() < end:
            time.sleep(0.05)
        folder = Path(os.environ["PROBE_ASSETS"])
        files = sorted(path for path in folder.rglob("*") if path.is_file())
        found = {path.relative_to(folder).as_posix(): path.read_text() for path in files}
        return json.dumps({"folder": str(folder), "files": found}).encode()
