"""`probe robustness`: a run against the same tasks under other conditions, task by task."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

import pydantic

from probe.api.grading import graded
from probe.api.rows import rows_of, setting_of_record
from probe.cli.checksum_notice import tell_unsummed
from probe.cli.metavars import RunFolder, RunFolders
from probe.cli.screen import ScreenTable, say, track
from probe.episodes.folder import SUITE
from probe.episodes.tool_errors import label_of
from probe.errors import BadData
from probe.files import write_text
from probe.runs.variation import read_variation
from probe.scores.marking import roster_of_tasks
from probe.scores.robustness import ConditionEffect, shifts
from probe.scores.row import Row
from probe.tasks.suite_file import read_suite
from probe.toolshed.version import tools_words


def robustness(
    plain: RunFolder,
    others: RunFolders,
    out: Path = Path("outputs/robustness.json"),
) -> None:
    """Compare a run with runs of the same tasks under other conditions.

    Args:
        plain: Folder of a run of the tasks as they were frozen.
        others: Folders of runs with other light, camera, table top, small moves, or an ideal tool.
        out: File for the figures.
    """
    if not others:
        raise BadData("probe robustness", "was given one folder", "Name others after the plain one")
    label, rows = _graded(plain)
    if label:
        raise BadData(plain, f"was run under other conditions ({label})", "Name a plain run first")
    found: dict[str, list[Row]] = {}
    broken: dict[str, frozenset[str]] = {}
    for folder in others:
        label, mine = _graded(folder)
        if not label or label in found:
            reason = "is a second run under " + (label or "no other conditions")
            raise BadData(folder, reason, "Name each conditions' run once")
        found[label] = mine
        variation = read_variation(folder)
        broken[label] = frozenset(variation.notes if variation else ())
    roster = roster_of_tasks(read_suite(plain / SUITE).tasks)
    made = shifts(rows, found, broken, roster)
    text = pydantic.TypeAdapter(list[ConditionEffect]).dump_json(made, indent=1).decode()
    write_text(out, text + "\n")
    _table(made).show()
    if words := tools_words(version for each in made for version in each.tools):
        say(f"{words}.")
    for each in made:
        say(_line(each))
    say(f"p is corrected for {len(made)} comparisons. All figures are in {out}.")


def _graded(folder: Path) -> tuple[str, list[Row]]:
    """The conditions of a folder's records, in words, and its rows."""
    suite = read_suite(folder / SUITE)
    found = graded(folder, track)
    tell_unsummed(folder)
    labels = {label_of(record, suite.headline, setting_of_record(record)) for _, record, _ in found}
    if len(labels) != 1:
        raise BadData(folder, f"holds runs under {len(labels)} conditions", "Name another folder")
    return labels.pop(), rows_of(folder, suite, found)


def _table(made: Iterable[ConditionEffect]) -> ScreenTable:
    table = ScreenTable("agent", "under", "n", "plain", "so", "points", "95 %", "p")
    for it in made:
        pair = it.pair
        table.add(
            pair.first.agent,
            it.conditions,
            str(pair.tasks),
            f"{it.plain:.1%}",
            f"{it.other:.1%}",
            f"{100 * pair.difference:+.1f}",
            f"{100 * pair.student.low:+.0f} to {100 * pair.student.high:+.0f}",
            f"{pair.adjusted:.2g}",
        )
    return table


def _line(it: ConditionEffect) -> str:
    """What must stand beside the table, in words."""
    alone = "" if it.certified is None else f", difference {100 * it.certified:+.1f} points"
    return (
        f"{it.pair.first.agent}, {it.conditions}: n = {it.pair.tasks} tasks, of which "
        f"{it.certified_tasks} still are what was certified{alone}; {it.missing} rows missing"
    )
