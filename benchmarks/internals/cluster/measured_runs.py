"""The episodes that a cluster is measured on, and commands that do them."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path

from probe.tasks.suite import selection, spaced
from probe.tasks.suite_file import packaged_suite, write_suite


def write_tasks(path: Path, count: int) -> Path:
    """A suite of tasks of v1, of all types."""
    whole = packaged_suite("v1")
    write_suite(path, selection(whole, spaced(whole.tasks, count), f"{count}-of-v1"))
    return path


def start(arguments: tuple[object, ...], variables: Mapping[str, str]) -> subprocess.Popen[str]:
    """A `probe` command that has been started; what it says is kept for its end."""
    return subprocess.Popen(
        [sys.executable, "-m", "probe", *map(str, arguments)],
        env={**os.environ, **variables},
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
    )
