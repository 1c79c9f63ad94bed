"""`probe rescore`: grade a run's records again and write down what they are worth."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import tyro
from rich.console import Console
from rich.table import Table

from probe.cli.run import graded
from probe.episodes.folder import SUITE
from probe.scores.marking import roster_of_tasks, row_of
from probe.scores.row_files import write_csv, write_json_lines
from probe.scores.scorecard import Figure
from probe.scores.summary import AGENTIC, Scores, summarise, write_scores
from probe.tasks.suite_file import read_suite

ROWS_CSV, ROWS_JSON, SCORES = "rows.csv", "rows.jsonl", "scores.json"

_ARMS = {"scripted": "scripted", "random": "random"}
"""Arms that are named after their agents."""


def rescore(out: Annotated[Path, tyro.conf.Positional], arm: str | None = None) -> None:
    """Grade a run's records again, without physics, and write rows.csv, rows.jsonl, scores.json.

    Args:
        out: Folder that `probe run` wrote to.
        arm: How the agents were allowed to answer; by default "agentic", and the scripted and the
            random agent have arms of their own.
    """
    suite = read_suite(out / SUITE)
    rows = [
        row_of(
            task,
            record,
            score,
            suite=suite.name,
            arm=arm or _ARMS.get(record.agent, AGENTIC),
        )
        for task, record, score in graded(out)
    ]
    scores = summarise(suite.name, rows, roster_of_tasks(suite.tasks))
    write_csv(out / ROWS_CSV, rows)
    write_json_lines(out / ROWS_JSON, rows)
    write_scores(out / SCORES, scores)
    Console().print(_table(scores))
    print(f"Rows are in {out / ROWS_CSV} and {out / ROWS_JSON}, all scores in {out / SCORES}.")


def _table(scores: Scores) -> Table:
    table = Table(title=f"Suite {scores.suite}", title_justify="left")
    for column in ("agent", "arm", "of", "tasks", "runs", "right", "95 % interval", "chance"):
        table.add_column(column)
    for card in scores.cards:
        for figure in (card.macro, *card.kinds, *card.parts):
            table.add_row(*card.entrant, *_cells(figure))
    return table


def _cells(figure: Figure) -> tuple[str, ...]:
    top, interval = figure.headline, figure.student
    right, range_ = "incomplete", f"{top.worst:.0%} to {top.best:.0%} in any case"
    if top.value is not None and interval is not None:
        right, range_ = f"{top.value:.1%}", f"{interval.low:.0%} to {interval.high:.0%}"
    return (figure.name, str(figure.tasks), str(figure.runs), right, range_, f"{figure.chance:.0%}")
