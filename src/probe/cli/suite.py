"""`probe suite`: build and show frozen suites of tasks."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from contextlib import closing
from pathlib import Path
from typing import Annotated

import tyro

from probe.api.resources import EVALUATION_POOL, Pool, library, opener, tables_for
from probe.assets.library import Library
from probe.assets.looks import NEWEST_LOOKS, Looks
from probe.cli.command_app import CommandApp
from probe.cli.engines import EngineChoice
from probe.cli.feasibility import Incomplete, show_possible
from probe.cli.metavars import SuiteFile, SuiteName
from probe.cli.numbers import check_numbers
from probe.cli.pool_notice import tell_other_pool
from probe.cli.running import AGAIN
from probe.cli.screen import ScreenTable, bar, say, say_above
from probe.cli.shards import parse_shard
from probe.cli.shortcuts import learn, shortcuts
from probe.cli.suite_certify import certify
from probe.cli.suite_verify import verify
from probe.engines.plan import Engine
from probe.errors import BadData, Unfinished
from probe.files import write_text
from probe.generation.build import (
    assemble,
    assemble_unsolved,
    begin,
    places_of,
    rules_for,
    why_none,
)
from probe.generation.build_folder import BuildFolder, CandidateLog, TaskSlot
from probe.generation.feasibility import possibilities
from probe.generation.making import TaskMaker, make_tasks
from probe.generation.plan import ATTEMPTS
from probe.generation.repeats import turned_back
from probe.generation.salt import Salt
from probe.render.lighting import require_light
from probe.report.build_log import count_candidates
from probe.scene.setup import UR5_TABLE, RendererName, newest
from probe.scene.setup_file import read_setup
from probe.tasks.suite_file import check_new_name, find_suite
from probe.tasks.task import QUESTION_TYPES, QuestionType, RulesVersion
from probe.verification.check import what_is_wrong

app = CommandApp()
app.command(shortcuts)
app.command(learn)
app.command(verify)
app.command(certify)

_NONE = dict.fromkeys(QUESTION_TYPES, 0)
_UNSOLVED_MOST = 50


@app.command
def build(
    out: SuiteFile,
    counts: dict[QuestionType, int] = _NONE,
    pool: Pool = EVALUATION_POOL,
    public: bool = False,
    first: int = 0,
    workers: int | None = None,
    where: Annotated[EngineChoice, tyro.conf.arg(name="")] = EngineChoice(),  # noqa: B008
    shard: str = "0/1",
    unchecked: bool = False,
    unsolved: Path | None = None,
    setup: Path | None = None,
    lighting: str | None = None,
    looks: Looks = NEWEST_LOOKS,
    renderer: RendererName = "filament",
    rules: RulesVersion | None = None,
) -> None:
    """Make, check and freeze tasks; continues where an earlier run stopped.

    Kept tasks and a log of every candidate wait in a folder beside the suite. Any number of
    processes may share the work; the last to end writes the suite, and the whole log beside it.
    A secret salt, drawn at the start and kept in that folder, decides letters, order and ids.
    Begins with a table of what the objects allow. What can't be made is left out and named at the
    end; the exit status is then 1.

    Args:
        out: File for the suite.
        counts: Tasks of each type: "--counts.find 28 --counts.compare 24".
        pool: Which objects appear, by default those for evaluation; the suite says it, and records
            say if some are for training. Scans need PROBE_ASSETS. With own+procedural, and with
            all, your objects take the important roles and the others fill in.
        public: Draw no salt, so that anyone can reproduce these tasks and predict their
            answers.
        first: With --public, number of the first episode of each type; others give other tasks.
        workers: Processes; by default 1, and on a cluster one on each core.
        where: On which machines.
        shard: "0/2" and "1/2" on two machines that see this folder share the work.
        unchecked: Don't measure tasks once more, and don't try whether what has to go can be moved
            and a scripted agent solves them: for tests of the generator, and for training.
        unsolved: File for up to 50 candidates that failed the scripted agents' check alone.
        setup: File of another set-up (docs/how-to/extend/add-a-setup.md); tasks keep it.
        lighting: Of the tasks' pictures, as for `probe scene`; tasks keep it.
        looks: How what is made by formula looks, as for `probe scene`; tasks keep it.
        renderer: What draws the tasks' pictures; tasks keep it. blender needs the extra of that
            name, and more time.
        rules: Version of the rules that tasks are made by; tasks keep it. By default 3; 2 of scans
            and of your own objects. 2 made v1, and leaks by height.
    """
    check_numbers({"--workers": workers})
    places = _asked(counts, first, public=public)
    check_new_name(out.stem, out)
    parts, things = BuildFolder(out.with_suffix(".parts")), library(pool)
    part = parse_shard(shard)
    table = newest(read_setup(setup) if setup else UR5_TABLE, lighting, looks, renderer)
    require_light(table.lighting, things.assets)
    rules = rules or rules_for(things)
    salt = begin(parts, pool, public=public, unchecked=unchecked, setup=table, rules=rules)
    tell_other_pool(things, "evaluation", "The suite and its records will say so.")
    left_out = _hopeless(places, set(_made(parts, places)), things, salt, rules)
    seen = None if where.store else parts
    audit = None if unchecked else what_is_wrong
    maker = TaskMaker(seen, opener(pool), tables_for(pool), audit, salt, table, rules)
    mine = [place for place in part.of(places) if place not in left_out]
    engine = where.engine(parts.folder, workers)
    _fill(maker, parts, mine, engine)
    lost = _waiting(parts, mine)
    waiting = _without_repeats(maker, parts, [p for p in places if p not in left_out], engine)
    left_out |= {p: why_none(parts.log(p)) for p in places if parts.is_exhausted(p, ATTEMPTS)}
    made = _made(parts, places)
    if lost:
        raise Unfinished(len(lost), len(places), "tasks", AGAIN)
    if waiting:
        say(f"{len(waiting)} of {len(places)} tasks aren't made yet; what there is: {parts.folder}")
        return
    if made:
        _finish(out, made, parts, things, salt, unsolved)
    if left_out:
        written = f"{out} has {len(made)} of {len(places)} tasks." if made else "No task was made."
        raise Incomplete(written, list(left_out.items()))


def _without_repeats(
    maker: TaskMaker, parts: BuildFolder, places: Sequence[TaskSlot], engine: Engine
) -> set[TaskSlot]:
    """Once all tasks are made, make those again that repeat another.

    Returns:
        Places without a task: others are still at work, or a worker died.
    """
    while not (waiting := _waiting(parts, places)):
        if not (again := turned_back(parts, places)):
            break
        _fill(maker, parts, again, engine)
    return waiting


def _made(parts: BuildFolder, places: Sequence[TaskSlot]) -> list[TaskSlot]:
    return [place for place in places if parts.task_path(place).exists()]


def _waiting(parts: BuildFolder, places: Sequence[TaskSlot]) -> set[TaskSlot]:
    """Places that somebody is still to make a task for."""
    lacking = set(places) - set(_made(parts, places))
    return {place for place in lacking if not parts.is_exhausted(place, ATTEMPTS)}


def _asked(counts: Mapping[QuestionType, int], first: int, *, public: bool) -> list[TaskSlot]:
    """The places that are asked for.

    Raises:
        BadData: None are, or the numbers make no sense.
    """
    asked = {f"--counts.{question_type}": count for question_type, count in counts.items()}
    check_numbers({"--first": first, **asked})
    if first and not public:
        reason = "numbers public tasks; a private suite's follow from its salt"
        raise BadData("--first", reason, "Say --public too, or leave it out")
    places = places_of(counts, first)
    if not places:
        raise BadData("--counts", "asks for no task", 'Say "--counts.find 2 --counts.count 2"')
    return places


@app.command
def show(suite: SuiteName) -> None:
    """List a suite's questions. Answers are shown: don't paste this to a model.

    Args:
        suite: One of the package ("v2", "demo"), or a file that `probe suite build` wrote.
    """
    table = ScreenTable("task", "type", "question", "options", "answer")
    tasks = find_suite(suite).tasks
    for task in tasks:
        options = "\n".join(f"{option.letter} {option.text}" for option in task.options)
        table.add(task.id, task.question_type, task.question, options, task.answer)
    table.show()
    taken = {(it.setup.lighting, it.setup.looks, it.setup.renderer) for it in tasks}
    for lighting, looks, renderer in sorted(taken):
        say(f"Pictures: light {lighting}, looks {looks}, drawn by {renderer}")


def _hopeless(
    places: Sequence[TaskSlot],
    made: Collection[TaskSlot],
    things: Library,
    salt: Salt | None,
    rules: RulesVersion,
) -> dict[TaskSlot, str]:
    """Tell what can be made; places for which the library lacks the things, and why."""
    if len(made) == len(places):
        return {}
    found = possibilities(places, things, salt, rules, made)
    show_possible(found, things)
    return {place: it.missing[0] for it in found for place in it.hopeless}


def _fill(maker: TaskMaker, parts: BuildFolder, places: Sequence[TaskSlot], engine: Engine) -> None:
    """Make tasks; a place for which none can be made doesn't end the others."""
    with bar() as progress, closing(make_tasks(maker, parts, places, engine)) as results:
        line = progress.add_task("Building", total=len(places))
        for place, problem in results:
            # A place's log says why none of its candidates was kept.
            if problem and not parts.is_exhausted(place, ATTEMPTS):
                say_above(progress, f"{place.question_type} {place.episode}: {problem}")
            done = f"Building, last {place.question_type} {place.episode}"
            progress.update(line, advance=1, description=done)


def _finish(
    out: Path,
    places: Sequence[TaskSlot],
    parts: BuildFolder,
    things: Library,
    salt: Salt | None,
    unsolved: Path | None,
) -> None:
    assemble(out, parts, places, things, salt)
    lines = [line for place in places for line in parts.log(place)]
    if salt:
        # By numbers that tell nothing: in the order of places, lines would tell a task's.
        lines.sort(key=lambda line: (line.question_type, line.seed))
    log = out.with_suffix(".log.tsv")
    write_text(log, "".join(f"{line}\n" for line in lines))
    _print_yield(lines)
    if unsolved:
        found = assemble_unsolved(unsolved, parts, places, things, _UNSOLVED_MOST, salt)
        say(f"{found} candidates failed the scripted agents' check alone; {unsolved} has some")
    say(f"{len(places)} tasks are in {out}; every candidate is in {log}")
    if salt:
        say(f"Keep {out} and {parts.folder} to yourself. The suite's commitment, for anyone:")
        say(salt.commitment)


def _print_yield(lines: Iterable[CandidateLog]) -> None:
    """Candidates by type, and by the check that rejected them."""
    table = ScreenTable(
        "type", "candidates", "kept", "seconds a kept one", "first attempt", "rejected"
    )
    for it in count_candidates(lines):
        table.add(
            it.question_type,
            str(it.candidates),
            f"{it.kept} ({it.kept / it.candidates:.0%})",
            f"{it.seconds / max(1, it.kept):.0f}",
            f"{it.solved} of {it.tried}" if it.tried else "",
            ", ".join(f"{check} {count}" for check, count in it.rejected),
        )
    table.show()
