"""Write docs/reference/cli.md: the help of every command; a test compares them."""

from __future__ import annotations

import io
import os
import re
import sys
from collections.abc import Iterator
from contextlib import redirect_stdout, suppress
from pathlib import Path

from probe.cli import COMMANDS, main

PAGE = Path(__file__).parents[1] / "docs" / "reference" / "cli.md"
WIDTH = 96

HEAD = """# The command line

On all pages, `probe` means `.venv/bin/probe`. This page shows what `probe --help` prints, and
`--help` after each command. `scripts/cli_page.py` writes it.
"""


def page() -> str:
    """The whole page."""
    parts = [HEAD, *_part([])]
    for name, command in COMMANDS.items():
        parts += _part([name])
        if command.nested:
            for nested in re.findall(r"^ +• ([\w-]+)", help_of([name]), re.MULTILINE):
                parts += _part([name, nested])
    return "\n".join(parts)


def help_of(command: list[str]) -> str:
    """What `--help` after a command prints, for a terminal of WIDTH columns without colours."""
    printed, arguments, settings = io.StringIO(), sys.argv, dict(os.environ)
    sys.argv = ["probe", *command, "--help"]
    os.environ |= {"COLUMNS": str(WIDTH), "NO_COLOR": "1"}
    try:
        with redirect_stdout(printed), suppress(SystemExit):
            main()
    finally:
        sys.argv = arguments
        os.environ.clear()
        os.environ.update(settings)
    return "\n".join(line.rstrip() for line in printed.getvalue().strip().splitlines())


def _part(command: list[str]) -> Iterator[str]:
    mark = "###" if len(command) > 1 else "##"
    yield f"{mark} `{' '.join(['probe', *command])}`\n"
    yield f"```text\n{help_of(command)}\n```\n"


if __name__ == "__main__":
    PAGE.write_text(page(), "utf-8")
