"""The scripts in runs/, as a user starts them."""

from __future__ import annotations

import os
import socket
import subprocess
import sys
from contextlib import ExitStack, suppress
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]


def run_script(name: str, *arguments: str, **settings: str) -> subprocess.CompletedProcess[str]:
    """Run one to its end, with settings in its environment."""
    return subprocess.run(
        [str(ROOT / "runs" / name), *arguments],
        env={**os.environ, "PROBE": f"{sys.executable} -m probe", **settings},
        capture_output=True,
        text=True,
        timeout=1800,
    )


def free_ports(count: int = 1) -> int:
    """The first of some ports in a row at which nobody listens."""
    while True:
        with ExitStack() as held, suppress(OSError, OverflowError):
            first = held.enter_context(socket.socket())
            first.bind(("127.0.0.1", 0))
            port = first.getsockname()[1]
            for n in range(1, count):
                held.enter_context(socket.socket()).bind(("127.0.0.1", port + n))
            return port
