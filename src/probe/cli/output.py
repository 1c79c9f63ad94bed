"""Standard output that takes no more is given up. Prints nothing."""

from __future__ import annotations

import contextlib
import os
import sys


def silence() -> None:
    """Let nothing more come out: what is left would be tried again when the interpreter ends."""
    with contextlib.suppress(OSError, ValueError):
        nowhere = os.open(os.devnull, os.O_WRONLY)
        os.dup2(nowhere, sys.stdout.fileno())
        os.close(nowhere)
