"""The paper's own table, with its averages worked out again."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache
from importlib.resources import files

import numpy as np
import pydantic
import yaml

RUNS = 3
"""Of each task, by the paper's protocol."""

_HALF = 0.05
"""By how much a number printed with one decimal may be off."""

_TINY = 1e-6


class PrintedRow(pydantic.BaseModel, frozen=True, extra="forbid"):
    """A model in a setting, in percent as printed."""

    model: str
    setting: str
    percent: dict[str, float]
    average: float
    gain: float | None = None


class PrintedTable(pydantic.BaseModel, frozen=True, extra="forbid"):
    """The table, and how many tasks each question type has."""

    tasks: dict[str, int]
    rows: tuple[PrintedRow, ...]


@dataclass(frozen=True)
class Recount:
    """What follows from a row's cells.

    Attributes:
        row: As printed.
        macro: Mean of its cells.
        pooled: Mean of its cells weighted by their tasks.
        follows: Rounding can make the printed average of the macro average.
        pooled_instead: It can't, but of the pooled one.
        gain: Printed average less that of the same model's direct row; None for that row.
        macro_gain: The same of the macro averages.
        gain_follows: Rounding can make the printed gain of `gain`, or there is none.
        unreachable: Types whose cell is no share of their tasks times runs, as all should be.
        single: Types whose cell is a share of their tasks alone, as if each was run once.
    """

    row: PrintedRow
    macro: float
    pooled: float
    follows: bool
    pooled_instead: bool
    gain: float | None
    macro_gain: float | None
    gain_follows: bool
    unreachable: tuple[str, ...]
    single: tuple[str, ...]


@lru_cache
def printed_table() -> PrintedTable:
    """The paper's Table 1."""
    text = (files("probe.scores") / "data" / "published.yaml").read_text(encoding="utf-8")
    return PrintedTable.model_validate(yaml.safe_load(text))


def recount(table: PrintedTable) -> list[Recount]:
    """Work out each row's averages and gains from its cells."""
    direct = {row.model: row for row in table.rows if row.setting == "direct"}
    return [_recount(row, direct.get(row.model), table.tasks) for row in table.rows]


def is_share(percent: float, of: int) -> bool:
    """Whether rounding can make this number of k / of, for any whole k."""
    nearest = 100 * round(percent * of / 100) / of
    return abs(nearest - percent) <= _HALF + _TINY


def _recount(row: PrintedRow, direct: PrintedRow | None, tasks: Mapping[str, int]) -> Recount:
    macro, pooled = _macro(row), _pooled(row, tasks)
    gain = macro_gain = None
    gain_follows = True
    if row.gain is not None and direct is not None:
        gain, macro_gain = row.average - direct.average, macro - _macro(direct)
        gain_follows = abs(gain - row.gain) < 3 * _HALF - _TINY
    follows = _may_be(row.average, macro)
    return Recount(
        row=row,
        macro=macro,
        pooled=pooled,
        follows=follows,
        pooled_instead=not follows and _may_be(row.average, pooled),
        gain=gain,
        macro_gain=macro_gain,
        gain_follows=gain_follows,
        unreachable=_kinds(
            row, {question_type: RUNS * n for question_type, n in tasks.items()}, reachable=False
        ),
        single=_kinds(row, tasks, reachable=True),
    )


def _macro(row: PrintedRow) -> float:
    return float(np.mean(list(row.percent.values())))


def _pooled(row: PrintedRow, tasks: Mapping[str, int]) -> float:
    weights = [tasks[question_type] for question_type in row.percent]
    return float(np.average(list(row.percent.values()), weights=weights))


def _may_be(printed: float, mean: float) -> bool:
    """Cells are rounded and so is their mean: together by less than 0.1."""
    return abs(printed - mean) < 2 * _HALF - _TINY


def _kinds(row: PrintedRow, of: Mapping[str, int], *, reachable: bool) -> tuple[str, ...]:
    return tuple(
        question_type
        for question_type, p in row.percent.items()
        if is_share(p, of[question_type]) == reachable
    )
