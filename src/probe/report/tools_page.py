"""The tools' own report: rates, causes, classes, and a picture of each failure."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from probe.report.rendering import write_page
from probe.tool_bench.summary import Summary


@dataclass(frozen=True)
class Failure:
    """A failed trial to look at: what was tried, what came of it, its picture's file."""

    title: str
    cause: str
    picture: str


def write_tools_page(
    path: Path, title: str, rest: str, summaries: Sequence[Summary], failures: Sequence[Failure]
) -> None:
    """Write the page; it opens from disk and loads nothing from elsewhere.

    Args:
        path: The page's file.
        title: Its title.
        rest: A line on how many tables weren't at rest and were drawn again.
        summaries: One a tool.
        failures: All of both tools.
    """
    values = {"title": title, "rest": rest, "summaries": summaries, "failures": failures}
    write_page(path, "tools.html", values)
