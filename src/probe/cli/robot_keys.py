"""Keys that a person presses in the terminal while a robot works."""

from __future__ import annotations

import os
import select
import sys
import termios
import threading
import tty
from collections.abc import Callable, Generator
from contextlib import contextmanager

_LOOK = 0.05
"""Seconds between two looks for a key's end of watching; a key itself is heard at once."""


@contextmanager
def keys(pressed: Callable[[str], None]) -> Generator[None]:
    """Tell of each key, as long as the block lasts; of each line where input is no terminal.

    Args:
        pressed: Gets the key; for a line its first sign, or a line feed if it is empty. It is
            called in a thread of its own.
    """
    ended = threading.Event()
    source = sys.stdin.fileno()
    terminal = os.isatty(source)
    before = termios.tcgetattr(source) if terminal else None
    if terminal:
        termios.tcflush(source, termios.TCIFLUSH)  # what was typed earlier answers nothing
        tty.setcbreak(source)
    thread = threading.Thread(target=_listen, args=(source, terminal, pressed, ended), name="keys")
    thread.start()
    try:
        yield
    finally:
        ended.set()
        thread.join()
        if before is not None:
            termios.tcsetattr(source, termios.TCSADRAIN, before)


def _listen(
    source: int, terminal: bool, pressed: Callable[[str], None], ended: threading.Event
) -> None:
    rest = ""
    while not ended.is_set():
        if not select.select([source], [], [], _LOOK)[0]:
            continue
        data = os.read(source, 1 if terminal else 1024).decode("utf-8", "replace")
        if not data:
            return
        if terminal:
            pressed(data)
            continue
        *lines, rest = (rest + data).split("\n")
        for text in lines:
            pressed(text[:1] or "\n")
