"""`probe --help`: the commands in groups, by what somebody is about to do."""

from __future__ import annotations

import shutil
import textwrap
from collections.abc import Iterator, Mapping

GROUPS: Mapping[str, tuple[str, ...]] = {
    "First steps": ("doctor", "demo", "scene"),
    "Evaluation": (
        *("run", "merge", "report", "report sim-real", "film", "rescore", "audit", "robustness"),
        "published",
    ),
    "Tasks, objects and tools": ("suite", "assets", "tools", "export"),
    "Other programs, people and robots": ("serve", "human", "robot"),
    "Training, in this order": (
        *("collect", "select", "dataset", "init-tiny", "unpack-model", "train", "serve-model"),
        *("ladder", "held-out"),
    ),
}
"""Names of commands by what they are for; others are listed last."""

_OTHERS = "More"
_LEAST, _MOST = 40, 100
"""Columns that the list may take."""


def overview(commands: Mapping[str, str]) -> Iterator[str]:
    """The lines of the list of commands.

    Args:
        commands: What each does, by its name.
    """
    width = max(_LEAST, min(_MOST, shutil.get_terminal_size().columns))
    left = 4 + max(map(len, commands))
    yield "usage: probe COMMAND [OPTIONS]"
    yield ""
    yield "A benchmark of questions about a cluttered table."
    grouped = {name for names in GROUPS.values() for name in names}
    others = tuple(name for name in commands if name not in grouped)
    for heading, names in {**GROUPS, _OTHERS: others}.items():
        if names:
            yield ""
            yield f"{heading}:"
        for name in names:
            first, *more = textwrap.wrap(commands[name], width - left)
            yield f"  {name}".ljust(left) + first
            yield from (" " * left + line for line in more)
    yield ""
    yield "`probe COMMAND --help` shows a command's options, `probe --version` the version."
