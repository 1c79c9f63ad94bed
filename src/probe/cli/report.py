"""`probe report`: a page of what agents did and what that is worth, of one run or of several."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Annotated

import tyro

from probe.audit.audit_file import audit_of
from probe.cli.gathering import gather, one_suite, short_names
from probe.cli.grading import darkroom_of
from probe.cli.rescore import ROWS_CSV, ROWS_JSON, SCORES, headline_line, write_beside
from probe.cli.screen import say
from probe.report.build_log import read_build_log
from probe.report.page import Report, write_report
from probe.scores.marking import roster_of_tasks
from probe.scores.summary import summarise

SEVERAL = Path("outputs/report")


def report(
    runs: Annotated[tuple[Path, ...], tyro.conf.Positional],
    out: Path | None = None,
    arm: str | None = None,
    build_log: Path | None = None,
    single_file: bool = False,
) -> None:
    """Grade records, without physics, and write a page of scores and replays.

    Args:
        runs: Folders that `probe run` wrote to; several of one suite are compared.
        out: Folder for the page; by default that of the run, for several outputs/report.
        arm: How the agents were allowed to answer; as in `probe rescore`.
        build_log: The log that `probe suite build` wrote beside the suite, for its yield.
        single_file: Write one file, report.html, that holds everything; for up to 20 episodes.
    """
    page = write_run_report(runs, out, arm=arm, build_log=build_log, single=single_file)
    say(f"Open {page} in a browser.")


def write_run_report(
    runs: Sequence[Path],
    out: Path | None = None,
    *,
    arm: str | None = None,
    build_log: Path | None = None,
    single: bool = False,
) -> Path:
    """Grade, draw and score what run folders hold; returns the page. See report().

    Raises:
        BadData: A folder can't be read.
        OtherSuite: The folders aren't about one suite.
        TooManyEpisodes: For a single file.
    """
    suite = one_suite(runs)
    candidates = read_build_log(build_log) if build_log else []
    folder = out or (runs[0] if len(runs) == 1 else SEVERAL)
    with darkroom_of(suite) as scene_renderer:
        played = gather(runs, suite, scene_renderer, folder, arm=arm, single=single)
    rows = [each.row for each in played]
    scores = summarise(suite.name, rows, roster_of_tasks(suite.tasks))
    write_beside(folder, rows, scores)
    page = folder / ("report.html" if single else "index.html")
    files = (ROWS_CSV, ROWS_JSON, SCORES)
    audits = tuple(
        (name, audit_of(run).words) for name, run in zip(short_names(runs), runs, strict=True)
    )
    shown = Report(suite, scores, played, tuple(candidates), files, audits)
    write_report(page, shown, single=single)
    for card in scores.cards:
        say(headline_line(card))
    for name, words in audits:
        say(f"{name}: {words}")
    return page
