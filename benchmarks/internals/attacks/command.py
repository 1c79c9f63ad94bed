"""Runs `probe` as a user would and judges what it says of something that it should refuse."""

from __future__ import annotations

import os
import resource
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path

from verdict import Attack

PATIENCE = 240.0
"""Seconds after which a command counts as hanging."""

MOST_BYTES = 12 << 30
"""Of addresses: what a command that reads without end may take of this machine."""

_USAGE = 2
"""Exit status of an option that can't be understood."""


_AS_HERE: Mapping[str, str] = {}


def probe(
    *words: str | Path,
    patience: float = PATIENCE,
    most_bytes: int = MOST_BYTES,
    environment: Mapping[str, str] = _AS_HERE,
) -> subprocess.CompletedProcess[str]:
    """A command that has ended.

    Args:
        words: Of the command, without "probe".
        patience: Seconds after which it counts as hanging.
        most_bytes: Of addresses that it may have.
        environment: What differs in it.

    Raises:
        subprocess.TimeoutExpired: It hangs; it has been killed.
    """
    return subprocess.run(
        [sys.executable, "-m", "probe", *map(str, words)],
        stdin=subprocess.DEVNULL,
        capture_output=True,
        text=True,
        errors="replace",
        timeout=patience,
        env=surroundings(environment),
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (most_bytes, most_bytes)),
    )


def surroundings(more: Mapping[str, str]) -> dict[str, str]:
    """The environment of a command: no colours, wide lines."""
    return {**os.environ, "NO_COLOR": "1", "COLUMNS": "1000", **more}


def refusal(
    kind: str,
    name: str,
    *words: str | Path,
    patience: float = PATIENCE,
    environment: Mapping[str, str] = _AS_HERE,
) -> Attack:
    """What becomes of a command that has to refuse something."""
    try:
        ended = probe(*words, patience=patience, environment=environment)
    except subprocess.TimeoutExpired:
        return Attack(kind, name, "crashed", f"hangs for {patience:.0f} s")
    return judged(kind, name, ended)


def judged(kind: str, name: str, ended: subprocess.CompletedProcess[str]) -> Attack:
    """Refused if the last line of a failed command says why, and no traceback does."""
    said = ended.stderr + ended.stdout
    lines = [line for line in ended.stderr.splitlines() if line.strip()]
    last = lines[-1] if lines else ""
    if "Traceback" in said or ended.returncode < 0:
        return Attack(kind, name, "crashed", last[-300:])
    if ended.returncode == 0:
        return Attack(kind, name, "read wrongly", said.strip()[-300:])
    clear = any(line.startswith("probe: ") for line in lines) or ended.returncode == _USAGE
    return Attack(kind, name, "refused" if clear else "crashed", last[-300:])
