"""Scores and reports of folders of records."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from probe.api.gathering import gather, one_suite, short_names
from probe.api.grading import graded, scene_renderer_of
from probe.api.progress import Track, silent
from probe.api.resources import audit_key_file
from probe.api.rows import ROWS_CSV, ROWS_JSON, SCORES, absent_of, rows_of, write_beside
from probe.audit.audit_file import audit_of
from probe.episodes.conditions import RendererKind
from probe.episodes.folder import SUITE
from probe.episodes.tool_errors import hands_words
from probe.report.build_log import read_build_log
from probe.report.page import Report
from probe.report.page import write_report as _write_report
from probe.scores.marking import roster_of_tasks
from probe.scores.summary import Scores, summarise
from probe.tasks.identity import identity_of
from probe.tasks.suite_file import read_suite

SEVERAL = Path("outputs/report")
"""Where a report of several folders goes, if nobody says otherwise."""


@dataclass(frozen=True)
class WrittenReport:
    """A report on disk.

    Attributes:
        page: The file to open in a browser.
        scores: Of everyone who answered.
        audits: The name of each folder, and how far it was audited, in words.
        remark: What has to stand beside the scores, since the suite isn't a whole packaged one.
        hands: What has to stand there, since hands err by different amounts.
    """

    page: Path
    scores: Scores
    audits: tuple[tuple[str, str], ...]
    remark: str = ""
    hands: str = ""


def rescore(folder: str | Path, *, setting: str | None = None, track: Track = silent) -> Scores:
    """Grade the records of a folder again, without physics.

    Writes rows.csv, rows.jsonl and scores.json into the folder. For a part of a packaged suite they
    name it as "demo (2 of 6 tasks)".

    Args:
        folder: Holds suite.json and records.jsonl, as `probe run` or `run` writes them.
        setting: How the agents were allowed to answer; by default as each record says.
        track: Watches the work.

    Raises:
        BadData: A file can't be read, or a record can't be of a run of the suite.
        OutputFailed: The scores can't be written.
    """
    out = Path(folder)
    suite = read_suite(out / SUITE)
    identity = identity_of(suite)
    found = graded(out, track)
    rows = rows_of(out, suite, found, setting, identity.title)
    absent = absent_of(out, suite, [record for _, record, _ in found], setting)
    roster = roster_of_tasks(suite.tasks)
    scores = summarise(identity.title, rows, roster, whole=identity.whole, absent=absent)
    write_beside(out, rows, scores)
    return scores


def write_report(
    folders: str | Path | Sequence[str | Path],
    out: str | Path | None = None,
    *,
    setting: str | None = None,
    build_log: str | Path | None = None,
    renderer: RendererKind = "own",
    single_file: bool = False,
    track: Track = silent,
) -> WrittenReport:
    """Grade, draw and score what folders of records hold, and write a page of it.

    Args:
        folders: One or several, about one suite; several are compared.
        out: Folder for the page; by default that of the records, for several outputs/report.
        setting: How the agents were allowed to answer; by default as each record says.
        build_log: The log that was written beside the suite when it was built, for its yield.
        renderer: What draws the pictures of replays: "own" for what drew them for each agent, or
            another; the page says so.
        single_file: Write one file that holds everything; for up to 20 episodes.
        track: Watches the work.

    Raises:
        BadData: A folder can't be read.
        OtherSuite: The folders aren't about one suite.
        NoRuns: There is no folder, or no record in any.
        TooManyEpisodes: For a single file.
        MissingExtra: Blender is to draw and isn't installed.
    """
    runs = [Path(it) for it in ([folders] if isinstance(folders, str | Path) else folders)]
    suite = one_suite(runs)
    candidates = read_build_log(Path(build_log)) if build_log else []
    folder = Path(out) if out else (runs[0] if len(runs) == 1 else SEVERAL)
    with scene_renderer_of(suite) as scene_renderer:
        found = gather(
            runs,
            suite,
            scene_renderer,
            folder,
            setting=setting,
            renderer=renderer,
            single=single_file,
            track=track,
        )
    played, identity = found.played, identity_of(suite)
    rows, roster = [each.row for each in played], roster_of_tasks(suite.tasks)
    scores = summarise(identity.title, rows, roster, whole=identity.whole, absent=found.absent)
    write_beside(folder, rows, scores)
    page = folder / ("report.html" if single_file else "index.html")
    audits = tuple(
        (name, audit_of(run, audit_key_file()).words)
        for name, run in zip(short_names(runs), runs, strict=True)
    )
    files = (ROWS_CSV, ROWS_JSON, SCORES)
    shown = Report(suite, scores, played, tuple(candidates), files, audits, renderer)
    _write_report(page, shown, single=single_file)
    hands = hands_words((each.record for each in played), suite.headline)
    return WrittenReport(page, scores, audits, identity.remark, hands)
