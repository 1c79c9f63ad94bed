"""`probe published`: the paper's own table, added up again."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from probe.cli.screen import Column, ScreenTable, say
from probe.scores.published import RUNS, Recount, printed_table, recount

_WIDTH = 110
"""Columns of the table where nobody looks on."""


def published() -> None:
    """Print the averages and gains of the paper's table as printed and as its cells give them."""
    table = printed_table()
    rows = recount(table)
    _table(rows).show(narrowest=_WIDTH)
    say(*_lines(rows, sum(table.tasks.values())))


def _table(rows: Sequence[Recount]) -> ScreenTable:
    names = ("", "setting", "printed", "of its cells", "by tasks", "follows", "gain", "of cells")
    words = ("", "setting", "follows")
    columns = [Column(name, justify="left" if name in words else "right") for name in names]
    shown = ScreenTable(*columns, title="Average over six types, per cent", left=True)
    for it in rows:
        row, gains = it.row, ("", "")
        if row.gain is not None and it.macro_gain is not None:
            gains = f"{row.gain:+.1f}{'' if it.gain_follows else ' *'}", f"{it.macro_gain:+.2f}"
        means = f"{row.average:.1f}", f"{it.macro:.2f}", f"{it.pooled:.2f}"
        shown.add(row.model, row.setting, *means, _verdict(it), *gains)
    return shown


def _verdict(it: Recount) -> str:
    if it.follows:
        return "yes"
    return "no, weighted by tasks" if it.pooled_instead else "no"


def _lines(rows: Sequence[Recount], tasks: int) -> Iterator[str]:
    """What doesn't follow, counted."""
    astray = [it for it in rows if not it.follows]
    pooled = sum(it.pooled_instead for it in astray)
    yield (
        f"{len(astray)} of {len(rows)} averages don't follow from their cells; {pooled} of these "
        f"are weighted by the {tasks} tasks instead, others beside them aren't."
    )
    gains = [it for it in rows if it.row.gain is not None and it.macro_gain is not None]
    off = [it.row.model for it in gains if not it.gain_follows]
    printed = sum(it.row.gain or 0.0 for it in gains) / len(gains)
    again = sum(it.macro_gain or 0.0 for it in gains) / len(gains)
    yield (
        f"* not the difference of the printed averages: {', '.join(off) or 'none'}. "
        f"The mean gain is {again:.1f} points of the cells, {printed:.1f} as printed."
    )
    cells = sum(len(it.row.percent) for it in rows)
    single = sum(len(it.single) for it in rows)
    unreachable = sum(len(it.unreachable) for it in rows)
    yield (
        f"{single} of {cells} cells are a share of their tasks run once; {unreachable} are no "
        f"share of {RUNS} runs of each task, which the protocol asks for."
    )
