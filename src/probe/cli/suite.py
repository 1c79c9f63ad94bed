"""`probe suite`: build and show frozen suites of tasks."""

from __future__ import annotations

from collections import Counter
from pathlib import Path
from typing import Annotated

import tyro
from rich.console import Console
from rich.progress import Progress
from rich.table import Table

from probe.assets.tables import table_ids
from probe.certify.build import Attempt, Workshop, assemble, attempts, keep, part_path
from probe.certify.result import Rejection
from probe.cli.shortcuts import learn, shortcuts
from probe.cli.surroundings import Pool, assets_folder, library
from probe.files import write_text
from probe.render.renderer import Renderer
from probe.tasks.suite_file import read_suite
from probe.tasks.task import KINDS, QuestionKind

app = tyro.extras.SubcommandApp()
app.command(shortcuts)
app.command(learn)


@app.command
def build(
    out: Annotated[Path, tyro.conf.Positional],
    each: int = 2,
    pool: Pool = "procedural",
    kinds: tuple[QuestionKind, ...] = KINDS,
    first: int = 0,
) -> None:
    """Make, check and freeze tasks of each type; goes on where an earlier run stopped.

    Kept tasks wait in a folder beside the suite; a line for every candidate is added to its log.

    Args:
        out: File for the suite.
        each: Tasks of each type.
        pool: Which objects appear; scans need PROBE_ASSETS.
        kinds: Types of question.
        first: Number of the first episode; other numbers give other tasks.
    """
    parts = out.with_suffix(".parts")
    things = library(pool)
    places = range(first, first + each)
    wanted: list[tuple[QuestionKind, int]] = [(kind, place) for kind in kinds for place in places]
    log: list[str] = []
    with Renderer() as renderer, Progress() as progress:
        workshop = Workshop(things, table_ids(assets_folder()), renderer)
        bar = progress.add_task("Building", total=len(wanted))
        for kind, episode in wanted:
            if not part_path(parts, kind, episode).exists():
                log = _log(parts)
                for attempt in attempts(kind, episode, workshop):
                    log.append(_line(kind, attempt))
                    write_text(parts / "log.txt", "\n".join(log) + "\n")
                    progress.update(bar, description=f"{kind} {episode}: {_short(attempt)}")
                    if not isinstance(attempt.result, Rejection):
                        keep(parts, kind, episode, attempt.result.task, things)
            progress.advance(bar)
    assemble(out, parts, wanted, things)
    _print_yield(_log(parts))
    print(f"{len(wanted)} tasks are in {out}; every candidate is in {parts / 'log.txt'}")


@app.command
def show(suite: Annotated[Path, tyro.conf.Positional]) -> None:
    """List a suite's questions. Answers are shown: don't paste this to a model.

    Args:
        suite: A file that `probe suite build` wrote.
    """
    table = Table("task", "type", "question", "options", "answer")
    for task in read_suite(suite).tasks:
        options = "\n".join(f"{option.letter} {option.text}" for option in task.options)
        table.add_row(task.id, task.kind, task.question, options, task.answer)
    Console().print(table)


def _log(parts: Path) -> list[str]:
    file = parts / "log.txt"
    return file.read_text().splitlines() if file.exists() else []


def _short(attempt: Attempt) -> str:
    return attempt.result.check if isinstance(attempt.result, Rejection) else "kept"


def _line(kind: QuestionKind, attempt: Attempt) -> str:
    """Type, seed, check, whether the very first scripted attempt succeeded, detail."""
    detail = attempt.result.detail if isinstance(attempt.result, Rejection) else ""
    solved = str(attempt.trials[0].solved) if attempt.trials else "-"
    return "\t".join([kind, str(attempt.seed), _short(attempt), solved, detail])


def _print_yield(lines: list[str]) -> None:
    """Candidates by type, and by the check that rejected them."""
    rows = [line.split("\t") for line in lines]
    table = Table("type", "candidates", "kept", "first scripted attempt, unselected", "rejected by")
    for kind in sorted({row[0] for row in rows}):
        mine = [row for row in rows if row[0] == kind]
        counts = Counter(row[2] for row in mine)
        kept = counts.pop("kept", 0)
        tried = [row for row in mine if row[3] != "-"]
        solved = sum(row[3] == "True" for row in tried)
        causes = ", ".join(f"{check} {count}" for check, count in counts.most_common())
        table.add_row(kind, str(len(mine)), str(kept), f"{solved} of {len(tried)}", causes)
    Console().print(table)
