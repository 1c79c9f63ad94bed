"""`probe held-out`: base, teacher and student in one table, with what nobody learnt apart."""

from __future__ import annotations

from collections.abc import Mapping
from importlib.resources import files
from pathlib import Path

from probe.agents.question_classifier import WEIGHTS, QuestionClassifier, read_learnt
from probe.api.grading import graded
from probe.api.rows import rows_of
from probe.cli.checksum_notice import tell_unsummed
from probe.cli.metavars import RunFolders
from probe.cli.screen import say, track
from probe.episodes.folder import SUITE
from probe.episodes.record import EpisodeRecord
from probe.episodes.tool_errors import hands_words
from probe.errors import BadData
from probe.files import write_text
from probe.scores.marking import roster_of_tasks
from probe.scores.row import Row
from probe.tasks.identity import identity_of
from probe.tasks.suite import Suite
from probe.tasks.suite_file import read_suite
from probe.tasks.task import QuestionType
from probe.texts import plural
from probe.train.baselines import floors
from probe.train.collect.aim import uncollected
from probe.train.differences import differences
from probe.train.differences import markdown as differences_table
from probe.train.held_out import markdown, standings

_PAIRS = (
    "Compared task by task over the trained types: 95 % intervals of each pair alone (t), and p of "
    "flipping signs within types, as it is and by Holm for {} pairs."
)


def held_out(
    runs: RunFolders,
    types: tuple[QuestionType, ...] | None = None,
    learnt: Path | None = None,
    out: Path = Path("outputs/held-out.md"),
) -> None:
    """Compare runs of a suite: a macro average over the trained types, and the others apart.

    Beside them stand the best constant answer and, where something was learnt, question-only. A
    second table compares them in pairs, with tests.

    Args:
        runs: Folders that `probe run` wrote, of one suite.
        types: Which nobody was trained on; by default those that `probe collect` doesn't collect by
            default.
        learnt: What question-only learnt (`probe suite learn`); by default the package's.
        out: File for the table.
    """
    if not runs:
        raise BadData("probe held-out", "was given no folder", "Name some that `probe run` wrote")
    suite = read_suite(runs[0] / SUITE)
    others = uncollected({it.question_type for it in suite.tasks}) if types is None else types
    rows, records = list[Row](), list[EpisodeRecord]()
    for folder in runs:
        asked = read_suite(folder / SUITE)
        if asked.tasks != suite.tasks:
            reason = f"is about other tasks than {runs[0]}"
            raise BadData(folder, reason, "Compare runs of one suite")
        found = graded(folder, track)
        rows += rows_of(folder, asked, found)
        records += [record for _, record, _ in found]
        tell_unsummed(folder)
    known = {row.entrant for row in rows}
    rows += [row for row in floors(suite, others, _learnt(learnt)) if row.entrant not in known]
    roster = roster_of_tasks(suite.tasks)
    table = markdown(standings(rows, roster, others))
    pairs = differences(rows, roster, others)
    text = f"{_words(suite, len(runs))}\n\n{table}"
    if pairs:
        text += f"\n{_PAIRS.format(len(pairs))}\n\n{differences_table(pairs)}"
    if words := hands_words(records, suite.headline):
        text += f"\n{words}.\n"
    write_text(out, text)
    say(*text.splitlines())
    say(f"This is in {out}.")


def _learnt(path: Path | None) -> Mapping[str, QuestionClassifier]:
    if path is None and not (files("probe.agents") / WEIGHTS).is_file():
        say("Question-only has learnt nothing yet: name a file with --learnt.")
        return {}
    return read_learnt(path)


def _words(suite: Suite, folders: int) -> str:
    title = identity_of(suite).title
    return (
        f"Right answers in per cent on {title}, {plural(len(suite.tasks), 'task')}, "
        f"{plural(folders, 'folder')}; in brackets 95 % intervals (t, over tasks). "
        "The constant answer is the one that is best over the trained types."
    )
