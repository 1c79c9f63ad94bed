"""`probe ladder`: which step of using the tools a model fails at, before it gets answers right."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from probe.api.grading import graded
from probe.api.rows import rows_of
from probe.cli.checksum_notice import tell_unsummed
from probe.cli.metavars import RunFolders
from probe.cli.screen import say, track
from probe.episodes.folder import SUITE
from probe.episodes.participation import has_tools
from probe.episodes.record import EpisodeRecord
from probe.errors import BadData
from probe.files import write_text
from probe.scores.row import Entrant
from probe.tasks.suite_file import read_suite
from probe.train.ladder import ladder as climbed
from probe.train.ladder import markdown


def ladder(runs: RunFolders, out: Path = Path("outputs/ladder.md")) -> None:
    """Say how many calls were well-formed, used listed places and valid object_ids, and were right.

    For models that are being trained: shares over all their calls, then over episodes. Settings
    without tools and episodes that our own fault ended are left out.

    Args:
        runs: Folders that `probe run` wrote.
        out: File for the table.
    """
    if not runs:
        raise BadData("probe ladder", "was given no folder", "Name some that `probe run` wrote")
    found = climbed(it for folder in runs for it in _episodes(folder))
    if not found:
        raise BadData(runs[0], "holds no episode with tools", "Run a setting that has tools")
    names = [who.title for who in found]
    table = markdown(list(zip(names, found.values(), strict=True)))
    write_text(out, table + "\n")
    say(*table.splitlines())
    say(f"This is in {out}.")


def _episodes(folder: Path) -> Iterator[tuple[Entrant, EpisodeRecord, bool]]:
    """Who played each episode with tools, its record, and whether it was right."""
    played = graded(folder, track)
    tell_unsummed(folder)
    rows = rows_of(folder, read_suite(folder / SUITE), played)
    for row, (_, record, _) in zip(rows, played, strict=True):
        # Rows also tell built-in agents that never look, which no record does.
        if has_tools(row.setting) and not row.missing:
            yield row.entrant, record, row.correct
