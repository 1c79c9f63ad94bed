"""`probe suite`: build and show frozen suites of tasks."""

from __future__ import annotations

import contextlib
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Annotated

import tyro
from rich.console import Console
from rich.table import Table

from probe.assets.library import Library
from probe.certify.build import (
    Workshop,
    assemble,
    assemble_unsolved,
    fill,
    places_of,
    why_none,
)
from probe.certify.parts import Line, Making, Parts, Place
from probe.certify.plan import ATTEMPTS
from probe.certify.possible import possibilities
from probe.cli.bars import bar
from probe.cli.possible import Incomplete, show_possible
from probe.cli.shards import parse_shard
from probe.cli.shortcuts import learn, shortcuts
from probe.cli.suite_certify import certify
from probe.cli.suite_verify import verify
from probe.cli.surroundings import Pool, library, tables_for
from probe.errors import BadData, Unsatisfiable
from probe.files import write_text
from probe.render.renderer import Renderer
from probe.report.build_log import count_candidates
from probe.tasks.suite_file import find_suite
from probe.tasks.task import KINDS, QuestionKind

app = tyro.extras.SubcommandApp()
app.command(shortcuts)
app.command(learn)
app.command(verify)
app.command(certify)

_NONE = dict.fromkeys(KINDS, 0)
_UNSOLVED_MOST = 50


@app.command
def build(
    out: Annotated[Path, tyro.conf.Positional],
    counts: dict[QuestionKind, int] = _NONE,
    pool: Pool = "procedural",
    first: int = 0,
    shard: str = "0/1",
    unchecked: bool = False,
    unsolved: Path | None = None,
) -> None:
    """Make, check and freeze tasks; goes on where an earlier run stopped.

    Kept tasks and a log of every candidate wait in a folder beside the suite. Any number of
    processes may share the work; the last to end writes the suite, and the whole log beside it.
    Begins with a table of what the objects allow. What can't be made is left out and named at the
    end; the exit status is then 1.

    Args:
        out: File for the suite.
        counts: Tasks of each type: "--counts.find 28 --counts.compare 24".
        pool: Which objects appear; scans need PROBE_ASSETS. With own+procedural, and with all, your
            own play the parts and others help out.
        first: Number of the first episode of each type; other numbers give other tasks.
        shard: "0/2" and "1/2" in two processes share the work.
        unchecked: Leave out the check that a scripted agent solves it, for tests of the generator.
        unsolved: File for up to 50 candidates that failed this check alone.
    """
    parts, things = Parts(out.with_suffix(".parts")), library(pool)
    places = places_of(counts, first)
    if not places:
        raise BadData("--counts", "asks for no task", 'Say "--counts.find 2 --counts.count 2"')
    part = parse_shard(shard)
    parts.claim(Making(pool=pool, unchecked=unchecked))
    left_out = _hopeless([p for p in places if not parts.task_path(p).exists()], things)
    with Renderer() as renderer:
        workshop = Workshop(things, tables_for(pool), renderer, unchecked)
        _fill([place for place in part.of(places) if place not in left_out], parts, workshop)
    left_out |= {p: why_none(parts.log(p)) for p in places if parts.is_exhausted(p, ATTEMPTS)}
    made = [place for place in places if parts.task_path(place).exists()]
    if waiting := len(places) - len(made) - len(left_out):
        print(f"{waiting} of {len(places)} tasks wait for other shards; parts: {parts.folder}")
        return
    if made:
        _finish(out, made, parts, things, unsolved)
    if left_out:
        written = f"{out} has {len(made)} of {len(places)} tasks." if made else "No task was made."
        raise Incomplete(written, list(left_out.items()))


@app.command
def show(suite: Annotated[str, tyro.conf.Positional]) -> None:
    """List a suite's questions. Answers are shown: don't paste this to a model.

    Args:
        suite: One of the package ("v1", "demo"), or a file that `probe suite build` wrote.
    """
    table = Table("task", "type", "question", "options", "answer")
    for task in find_suite(suite).tasks:
        options = "\n".join(f"{option.letter} {option.text}" for option in task.options)
        table.add_row(task.id, task.kind, task.question, options, task.answer)
    Console().print(table)


def _hopeless(places: Sequence[Place], things: Library) -> dict[Place, str]:
    """Tell what can be made; places for which the library lacks the things, and why."""
    found = possibilities(places, things)
    if found:
        show_possible(found, things)
    return {place: it.missing[0] for it in found for place in it.hopeless}


def _fill(places: Sequence[Place], parts: Parts, workshop: Workshop) -> None:
    """Make tasks; a place for which none can be made doesn't end the others."""
    with bar() as progress:
        line = progress.add_task("Building", total=len(places))
        for place in places:
            # What was tried is in the place's log.
            with contextlib.suppress(Unsatisfiable):
                for tried in fill(place, parts, workshop):
                    done = f"{place.kind} {place.episode}: {tried.check}"
                    progress.update(line, description=done)
            progress.advance(line)


def _finish(
    out: Path, places: Sequence[Place], parts: Parts, things: Library, unsolved: Path | None
) -> None:
    assemble(out, parts, places, things)
    lines = [line for place in places for line in parts.log(place)]
    log = out.with_suffix(".log.tsv")
    write_text(log, "".join(f"{line}\n" for line in lines))
    _print_yield(lines)
    if unsolved:
        found = assemble_unsolved(unsolved, parts, places, things, _UNSOLVED_MOST)
        print(f"{found} candidates failed the scripted agents' check alone; {unsolved} has some")
    print(f"{len(places)} tasks are in {out}; every candidate is in {log}")


def _print_yield(lines: Iterable[Line]) -> None:
    """Candidates by type, and by the check that rejected them."""
    table = Table("type", "candidates", "kept", "seconds a kept one", "first attempt", "rejected")
    for it in count_candidates(lines):
        table.add_row(
            it.kind,
            str(it.candidates),
            f"{it.kept} ({it.kept / it.candidates:.0%})",
            f"{it.seconds / max(1, it.kept):.0f}",
            f"{it.solved} of {it.tried}" if it.tried else "",
            ", ".join(f"{check} {count}" for check, count in it.rejected),
        )
    Console().print(table)
