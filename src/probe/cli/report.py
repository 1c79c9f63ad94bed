"""`probe report`: a page of what agents did and what that is worth, of one run or of several."""

from __future__ import annotations

import webbrowser
from collections.abc import Sequence
from pathlib import Path
from typing import Annotated

import tyro

from probe.api import reports
from probe.cli.checksum_notice import tell_unsummed
from probe.cli.metavars import RunFolders
from probe.cli.rescore import headline_line
from probe.cli.screen import say, track
from probe.episodes.conditions import RendererKind
from probe.scores.sight import sight_words
from probe.toolshed.version import tools_words


def report(
    runs: RunFolders,
    out: Path | None = None,
    setting: Annotated[str | None, tyro.conf.arg(aliases=["--arm"])] = None,
    build_log: Path | None = None,
    renderer: RendererKind = "own",
    single_file: bool = False,
    open: bool = False,
) -> None:
    """Grade records, without physics, and write a page of scores and replays.

    Args:
        runs: Folders that `probe run` wrote to; several of one suite are compared.
        out: Folder for the page; by default that of the run, for several outputs/report.
        setting: How the agents were allowed to answer; as in `probe rescore`.
        build_log: The log that `probe suite build` wrote beside the suite, for its yield.
        renderer: What draws the pictures of replays: what drew them for each agent, or
            another; blender needs the extra of that name, and more time.
        single_file: Write one file, report.html, that holds everything; for up to 20 episodes.
        open: Show the page in a browser.
    """
    page = write_run_report(
        runs, out, setting=setting, build_log=build_log, renderer=renderer, single=single_file
    )
    if not (open and webbrowser.open(page.resolve().as_uri())):
        say(f"Open {page} in a browser.")


def write_run_report(
    runs: Sequence[Path],
    out: Path | None = None,
    *,
    setting: str | None = None,
    build_log: Path | None = None,
    renderer: RendererKind = "own",
    single: bool = False,
) -> Path:
    """Write a report and say what it holds; returns the page."""
    written = reports.write_report(
        runs,
        out,
        setting=setting,
        build_log=build_log,
        renderer=renderer,
        single_file=single,
        track=track,
    )
    for run in runs:
        tell_unsummed(run)
    for card in written.scores.cards:
        say(headline_line(card))
    if words := tools_words(card.tools for card in written.scores.cards):
        say(f"{words}.")
    if words := sight_words(card.entrant.setting for card in written.scores.cards):
        say(f"{words}.")
    if written.hands:
        say(f"{written.hands}.")
    if written.remark:
        say(f"{written.remark}.")
    for name, words in written.audits:
        say(f"{name}: {words}")
    return written.page
