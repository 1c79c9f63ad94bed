"""`probe rescore`: grade a run's records again and write down what they are worth."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import Annotated

import tyro

from probe.api import reports
from probe.api.resources import audit_key_file
from probe.api.rows import ROWS_CSV, ROWS_JSON, SCORES
from probe.audit.audit_file import audit_of
from probe.cli.checksum_notice import tell_unsummed
from probe.cli.metavars import RunFolder
from probe.cli.screen import ScreenTable, say, track
from probe.episodes.folder import SUITE
from probe.report.episodes import name_of
from probe.scores.scorecard import Figure, Scorecard
from probe.scores.summary import AGENTIC, DIRECT, Scores
from probe.tasks.identity import identity_of
from probe.tasks.suite_file import read_suite
from probe.texts import plural

_FLOORS = (
    "Chance is a blind guess; naive is a guess after a look: all right where no manipulation is "
    "necessary, in Count what is visible and 0, 1 or 2 more, elsewhere as chance. Beyond is "
    "accuracy beyond chance, relative to naive: 0 % for it, 100 % for all right."
)
_RESTRAINED = (
    "Restrained is right with at most one manipulation more than necessary; below it are the tasks "
    "by how many are necessary."
)


def rescore(
    out: RunFolder,
    setting: Annotated[str | None, tyro.conf.arg(aliases=["--arm"])] = None,
) -> None:
    """Grade a run's records again, without physics, and write rows.csv, rows.jsonl, scores.json.

    Args:
        out: Folder that `probe run` wrote to.
        setting: How the agents were allowed to answer; by default "agentic", and agents without
            a model have settings of their own.
    """
    scores = reports.rescore(out, setting=setting, track=track)
    tell_unsummed(out)
    for card in scores.cards:
        _table(card).show()
    if scores.cards:
        say(_FLOORS)
    if any(card.by_necessary for card in scores.cards):
        say(_RESTRAINED)
    if remark := identity_of(read_suite(out / SUITE)).remark:
        say(f"{out}: {remark}.")
    for line in _lines(scores):
        say(line)
    say(f"{out}: {audit_of(out, audit_key_file()).words}.")
    say(f"Rows are in {out / ROWS_CSV} and {out / ROWS_JSON}, all scores in {out / SCORES}.")


def headline_line(card: Scorecard) -> str:
    """One entrant's headline in a line."""
    _, _, runs, right, interval, chance, naive, _ = _cells(card.macro)
    of = plural(card.macro.headline.rows, "run")
    sizes = f"n = {plural(card.macro.tasks, 'task')}, {runs} of {of}"
    return f"{name_of(card.entrant)}: {right} ({interval}), {sizes}, chance {chance}, naive {naive}"


def _table(card: Scorecard) -> ScreenTable:
    columns = ("", "tasks", "runs", "right", "95 % interval", "chance", "naive", "beyond")
    table = ScreenTable(*columns, title=name_of(card.entrant), left=True)
    for figure in (card.macro, *card.question_types, *card.parts, *_by_restraint(card)):
        table.add(*_cells(figure))
    return table


def _by_restraint(card: Scorecard) -> Iterator[Figure]:
    """What suites give whose tasks state how many manipulations are necessary."""
    if card.restrained is not None:
        yield card.restrained
    for figure in card.by_necessary:
        yield replace(figure, name=f"{figure.name} necessary")


def _lines(scores: Scores) -> Iterator[str]:
    """What must stand beside the table, in words."""
    for card in scores.cards:
        resemblance = "unknown" if card.icc is None else f"{card.icc:.2f}"
        gone = plural(len(card.gaps), "row")
        gap = "unknown" if card.detectable is None else f"{100 * card.detectable:.0f} points"
        if card.detectable is not None and card.detectable > 1:
            gap = "none, with so few tasks"
        yield (
            f"{name_of(card.entrant)}: n = {plural(card.macro.tasks, 'task')}; "
            f"ICC of runs {resemblance}; "
            f"detectable difference from an unrelated agent {gap}; {gone} missing{_needless(card)}"
        )
    for pair in scores.all_pairs:
        verdict = "a tie" if pair.tie else "different"
        names = f"{name_of(pair.first)} less {name_of(pair.second)}"
        yield (
            f"{names}: {100 * pair.difference:+.1f} points "
            f"({100 * pair.student.low:+.0f} to {100 * pair.student.high:+.0f}), n = {pair.tasks}, "
            f"p = {pair.p:.2g}, corrected {pair.adjusted:.2g}: {verdict}"
        )
    if scores.settings is not None:
        yield (
            f"{AGENTIC} against {DIRECT} over {scores.settings.agents} agents: "
            f"p = {scores.settings.p:.2g} (plain CMH {scores.settings.plain_p:.2g})"
        )


def _needless(card: Scorecard) -> str:
    if card.needless is None:
        return ""
    return f"; {card.needless.mean:.1f} needless manipulations an episode"


def _cells(figure: Figure) -> tuple[str, ...]:
    top, interval = figure.headline, figure.student
    right, range_ = "incomplete", f"in any case {top.worst:.0%} to {top.best:.0%}"
    if top.value is not None and interval is not None:
        right, range_ = f"{top.value:.1%}", f"{interval.low:.0%} to {interval.high:.0%}"
    beyond = "" if figure.corrected is None else f"{figure.corrected:.0%}"
    floors = f"{figure.chance:.0%}", f"{figure.naive:.0%}", beyond
    return (figure.name, str(figure.tasks), str(figure.runs), right, range_, *floors)
