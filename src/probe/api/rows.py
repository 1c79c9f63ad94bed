"""From a folder's graded records to rows, and the files of scores that lie beside them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from pathlib import Path

from probe.api.agents import SETTINGS
from probe.api.grading import Graded
from probe.episodes.folder import setting_of_folder
from probe.episodes.ordered import Ordered, read_ordered
from probe.episodes.record import EpisodeRecord
from probe.scores.marking import row_of, under
from probe.scores.missing import Absent
from probe.scores.row import Entrant, Row
from probe.scores.row_files import write_csv, write_json_lines
from probe.scores.summary import AGENTIC, Scores, write_scores
from probe.tasks.suite import Suite
from probe.toolshed.version import TOOLS_VERSION

ROWS_CSV, ROWS_JSON, SCORES = "rows.csv", "rows.jsonl", "scores.json"


def setting_of(agent: str) -> str:
    """How an agent answers, if nobody says otherwise."""
    return SETTINGS.get(agent, AGENTIC)


def setting_of_record(record: EpisodeRecord) -> str:
    """How an agent answered: as its record says, or as is usual for it."""
    return record.setting or setting_of(record.agent)


def rows_of(
    out: Path,
    suite: Suite,
    records: Iterable[Graded],
    setting: str | None = None,
    title: str | None = None,
) -> list[Row]:
    """The rows of a folder's graded records.

    Args:
        out: The folder: it knows how many runs there were to be, and whether people answered.
        suite: Its suite.
        records: Its records.
        setting: How the agents were allowed to answer; by default as the folder or the record
            says, or as is usual for the agent.
        title: What the suite is called in the rows; by default its name.
    """
    setting, ordered = setting or setting_of_folder(out), read_ordered(out)
    suite = replace(suite, name=title or suite.name)
    return [_row(suite, each, setting, ordered) for each in records]


def absent_of(
    out: Path, suite: Suite, records: Sequence[EpisodeRecord], setting: str | None = None
) -> list[Absent]:
    """Who was ordered in a folder and has no record there.

    Args:
        out: The folder.
        suite: Its suite.
        records: All of its records; they say under which conditions the others were to be run.
        setting: As in rows_of.
    """
    setting, first = setting or setting_of_folder(out), next(iter(records), None)
    there = {(it.agent, it.setting) for it in records}
    absent = list[Absent]()
    for (agent, own), runs in read_ordered(out).items():
        if (agent, own) not in there:
            said = setting or own or setting_of(agent)
            named = said if first is None else under(said, first, suite.headline)
            tools = TOOLS_VERSION if first is None else first.tools
            absent.append(Absent(Entrant(agent, named), runs, tools))
    return absent


def write_beside(folder: Path, rows: Sequence[Row], scores: Scores) -> None:
    """Write rows.csv, rows.jsonl and scores.json.

    Raises:
        OutputFailed: They can't be written.
    """
    write_csv(folder / ROWS_CSV, rows)
    write_json_lines(folder / ROWS_JSON, rows)
    write_scores(folder / SCORES, scores)


def _row(suite: Suite, graded: Graded, setting: str | None, ordered: Ordered) -> Row:
    task, record, score = graded
    setting = setting or setting_of_record(record)
    runs = ordered.get((record.agent, record.setting))
    return row_of(
        task,
        record,
        score,
        suite=suite.name,
        setting=setting,
        ordered=runs,
        headline=suite.headline,
    )
