"""The operator of a session at a terminal."""

from __future__ import annotations

import sys

from probe.cli.screen import say
from probe.errors import BadData


class TerminalOperator:
    """Tells on the screen and listens to the keyboard; see probe.runs.session.operator."""

    def tell(self, *lines: str) -> None:
        """Print some lines."""
        say(*lines)

    def ask(self, words: str) -> str:
        """Print a question and read a line.

        Raises:
            BadData: There is nobody to answer.
        """
        say(words.rstrip())
        line = sys.stdin.readline()
        if not line:
            raise BadData("standard input", "has ended", "Run it in a terminal")
        return line.strip()
