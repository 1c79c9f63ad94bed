"""`probe rescore`: grade a run's records again and write down what they are worth."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from typing import Annotated

import tyro

from probe.audit.audit_file import audit_of
from probe.cli.agents import ARMS
from probe.cli.grading import Graded, graded
from probe.cli.screen import ScreenTable, say
from probe.episodes.folder import SUITE, arm_of_folder
from probe.episodes.ordered import Ordered, read_ordered
from probe.scores.marking import roster_of_tasks, row_of
from probe.scores.row import Entrant, Row
from probe.scores.row_files import write_csv, write_json_lines
from probe.scores.scorecard import Figure, Scorecard
from probe.scores.summary import AGENTIC, DIRECT, Scores, summarise, write_scores
from probe.tasks.suite_file import read_suite

_FLOORS = (
    "Chance is a blind guess; naive is what needs no moving (Count: what shows, and 0, 1 or 2 "
    "more); beyond is accuracy beyond chance, reckoned from naive: 0 % for it, 100 % for all right."
)

ROWS_CSV, ROWS_JSON, SCORES = "rows.csv", "rows.jsonl", "scores.json"


def rescore(out: Annotated[Path, tyro.conf.Positional], arm: str | None = None) -> None:
    """Grade a run's records again, without physics, and write rows.csv, rows.jsonl, scores.json.

    Args:
        out: Folder that `probe run` wrote to.
        arm: How the agents were allowed to answer; by default "agentic", and agents without
            a model have arms of their own.
    """
    suite = read_suite(out / SUITE)
    rows = rows_of(out, suite.name, graded(out), arm)
    scores = summarise(suite.name, rows, roster_of_tasks(suite.tasks))
    write_beside(out, rows, scores)
    for card in scores.cards:
        _table(card).show()
    if scores.cards:
        say(_FLOORS)
    for line in _lines(scores):
        say(line)
    say(f"{out}: {audit_of(out).words}.")
    say(f"Rows are in {out / ROWS_CSV} and {out / ROWS_JSON}, all scores in {out / SCORES}.")


def arm_of(agent: str) -> str:
    """How an agent answers, if nobody says otherwise."""
    return ARMS.get(agent, AGENTIC)


def rows_of(out: Path, suite: str, records: Iterable[Graded], arm: str | None = None) -> list[Row]:
    """The rows of a folder's graded records.

    Args:
        out: The folder: it knows how many runs there were to be, and whether people sat there.
        suite: Its suite's name.
        records: Its records.
        arm: How the agents were allowed to answer; by default as the folder or the record says, or
            as is usual for the agent.
    """
    arm, ordered = arm or arm_of_folder(out), read_ordered(out)
    return [_row(suite, each, arm, ordered) for each in records]


def _row(suite: str, graded: Graded, arm: str | None, ordered: Ordered) -> Row:
    task, record, score = graded
    arm = arm or record.arm or arm_of(record.agent)
    runs = ordered.get((record.agent, record.arm))
    return row_of(task, record, score, suite=suite, arm=arm, ordered=runs)


def write_beside(folder: Path, rows: Sequence[Row], scores: Scores) -> None:
    """Write rows.csv, rows.jsonl and scores.json.

    Raises:
        OutputFailed: They can't be written.
    """
    write_csv(folder / ROWS_CSV, rows)
    write_json_lines(folder / ROWS_JSON, rows)
    write_scores(folder / SCORES, scores)


def headline_line(card: Scorecard) -> str:
    """One entrant's headline in a line."""
    _, tasks, runs, right, interval, chance, naive, _ = _cells(card.macro)
    sizes = f"n = {tasks} tasks, {runs} of {card.macro.headline.rows} runs"
    return f"{_name(card.entrant)}: {right} ({interval}), {sizes}, chance {chance}, naive {naive}"


def _table(card: Scorecard) -> ScreenTable:
    columns = ("", "tasks", "runs", "right", "95 % interval", "chance", "naive", "beyond")
    table = ScreenTable(*columns, title=_name(card.entrant), left=True)
    for figure in (card.macro, *card.kinds, *card.parts):
        table.add(*_cells(figure))
    return table


def _lines(scores: Scores) -> Iterator[str]:
    """What must stand beside the table, in words."""
    for card in scores.cards:
        resemblance = "unknown" if card.icc is None else f"{card.icc:.2f}"
        gap = "unknown" if card.detectable is None else f"{100 * card.detectable:.0f} points"
        if card.detectable is not None and card.detectable > 1:
            gap = "none, with so few tasks"
        yield (
            f"{_name(card.entrant)}: n = {card.macro.tasks} tasks; ICC of runs {resemblance}; "
            f"detectable difference from an unrelated agent {gap}; {len(card.gaps)} rows missing"
        )
    for pair in scores.all_pairs:
        verdict = "a tie" if pair.tie else "different"
        yield (
            f"{_name(pair.first)} less {_name(pair.second)}: {100 * pair.difference:+.1f} points "
            f"({100 * pair.student.low:+.0f} to {100 * pair.student.high:+.0f}), n = {pair.tasks}, "
            f"p = {pair.p:.2g}, corrected {pair.adjusted:.2g}: {verdict}"
        )
    if scores.arms is not None:
        yield (
            f"{AGENTIC} against {DIRECT} over {scores.arms.agents} agents: "
            f"p = {scores.arms.p:.2g} (plain CMH {scores.arms.plain_p:.2g})"
        )


def _name(entrant: Entrant) -> str:
    return f"{entrant.agent} ({entrant.arm})"


def _cells(figure: Figure) -> tuple[str, ...]:
    top, interval = figure.headline, figure.student
    right, range_ = "incomplete", f"in any case {top.worst:.0%} to {top.best:.0%}"
    if top.value is not None and interval is not None:
        right, range_ = f"{top.value:.1%}", f"{interval.low:.0%} to {interval.high:.0%}"
    beyond = "" if figure.corrected is None else f"{figure.corrected:.0%}"
    floors = f"{figure.chance:.0%}", f"{figure.naive:.0%}", beyond
    return (figure.name, str(figure.tasks), str(figure.runs), right, range_, *floors)
