"""`probe suite verify`: check every task of a frozen suite again."""

from __future__ import annotations

from collections.abc import Generator, Iterator, Sequence
from contextlib import closing
from itertools import chain
from pathlib import Path
from typing import Annotated

import tyro

from probe.api.resources import Pool, opener, tables_for
from probe.assets.library import Library
from probe.cli.engines import EngineChoice
from probe.cli.metavars import SuiteName
from probe.cli.numbers import check_numbers
from probe.cli.objects import all_objects, check
from probe.cli.running import AGAIN
from probe.cli.screen import ScreenTable, bar, say, say_above
from probe.cli.shards import parse_shard
from probe.cli.suite_salt import origins_by
from probe.engines.plan import Engine, LostUnit, WorkPlan
from probe.errors import ProbeError, Unfinished
from probe.tasks.suite import Suite, spaced
from probe.tasks.suite_file import digest_of, find_suite
from probe.tasks.task import Task
from probe.verification.balance import balances
from probe.verification.check import CheckDepth
from probe.verification.salt import salt_problems
from probe.verification.text import read_anew
from probe.verification.verdict import CHECKS, TaskVerdict, read_verdict, write_verdict
from probe.verification.verifying import Rebuilder, SuiteVerifier


class Unverified(ProbeError):
    """Tasks of a suite failed checks."""

    def __init__(self, suite: str, failed: int, out: Path) -> None:
        super().__init__(
            f"{failed} tasks of suite {suite} fail a check; {out} says which. Use the assets and "
            "the release it was made with; if these are the same, report it."
        )


def verify(
    suite: SuiteName,
    out: Path | None = None,
    solve: bool = True,
    histories: int = 0,
    rebuild: int = 0,
    salt: Path | None = None,
    pool: Pool | None = None,
    workers: int | None = None,
    where: Annotated[EngineChoice, tyro.conf.arg(name="")] = EngineChoice(),  # noqa: B008
    shard: str = "0/1",
) -> None:
    """Check each task: text, at rest, hidden, true, unambiguous, solvable; may be interrupted.

    Args:
        suite: One of the package ("v2", "demo"), or a file that `probe suite build` wrote.
        out: Folder for the verdicts, by default outputs/verify-NAME; those that are there stand.
        solve: Whether scripted agents have to solve each task again.
        histories: On how many tasks, evenly spaced, three random histories are played.
        rebuild: How many tasks, evenly spaced, are made from their seeds again.
        salt: File of a private suite's salt: do the tasks follow from what it was committed to?
        pool: Which objects the suite was made of, for that; by default those that it names, or
            procedural if it names none.
        workers: Processes; by default 1, and on a cluster one on each core.
        where: On which machines.
        shard: "0/2" and "1/2" on two machines that see this folder share the work; then run once
            more without.
    """
    check_numbers({"--histories": histories, "--rebuild": rebuild, "--workers": workers})
    frozen, things = find_suite(suite), all_objects()
    known = origins_by(frozen, salt, rebuild)
    check(frozen, things)
    folder = out or Path("outputs") / f"verify-{frozen.name}"
    part = parse_shard(shard)
    played = {task.id for task in spaced(frozen.tasks, histories)}
    engine = where.engine(folder, workers)
    verifier = SuiteVerifier(opener(), solve, frozenset(played))
    mine = part.of(frozen.tasks)
    verdicts = _verdicts(frozen, mine, folder, things, verifier, engine)
    again = [task for task in spaced(mine, rebuild) if known is None or task.id in known]
    made_of = pool or frozen.pool or "procedural"
    rebuilder = Rebuilder(opener(made_of), made_of, tables_for(made_of), known or {})
    changed = _rebuilt(frozen, again, rebuilder, engine)
    _print(frozen, verdicts, changed, len(again))
    strange = [] if known is None else list(salt_problems(frozen, known))
    if known is not None:
        _print_salt(frozen, strange)
    if failed := sum(not verdict.holds for verdict in verdicts) + len(changed) + len(strange):
        raise Unverified(frozen.name, failed, folder)


def _verdicts(
    suite: Suite,
    tasks: Sequence[Task],
    folder: Path,
    things: Library,
    verifier: SuiteVerifier,
    engine: Engine,
) -> list[TaskVerdict]:
    """Verdicts on tasks, in their order; those that stand already aren't made again.

    Raises:
        Unfinished: Workers died over some.
    """
    verdicts = {task.id: _standing(task, folder, things, verifier) for task in tasks}
    waiting = [task for task in tasks if verdicts[task.id] is None]
    results = _results("Verifying", verifier.plan(suite, waiting), len(tasks), engine)
    with closing(results):
        for task, result in results:
            found = verdicts[task.id] = TaskVerdict.model_validate_json(result)
            write_verdict(folder / f"{task.id}.json", found)
    return [verdict for verdict in verdicts.values() if verdict is not None]


def _results(
    doing: str, plan: WorkPlan[Task], total: int, engine: Engine
) -> Generator[tuple[Task, bytes]]:
    """What comes of a plan's tasks, with a bar that counts those of before as well.

    Raises:
        Unfinished: Workers died over some; it comes last.
    """
    lost = 0
    with bar() as progress, closing(engine.carry_out(plan)) as results:
        line = progress.add_task(doing, total=total, completed=total - len(plan.units))
        for task, result in results:
            if isinstance(result, LostUnit):
                say_above(progress, f"{task.id}: {result.reason}")
                lost += 1
            else:
                yield task, result
            progress.advance(line)
    if lost:
        raise Unfinished(lost, total, "tasks", AGAIN)


def _standing(
    task: Task, folder: Path, things: Library, verifier: SuiteVerifier
) -> TaskVerdict | None:
    """The verdict that is there, if it is of this task and goes deep enough."""
    path = folder / f"{task.id}.json"
    found = read_verdict(path) if path.exists() else None
    if found is None or not _stands(found, task, verifier.depth(task)):
        return None
    if "text" not in found.problems:
        found = _with_text(found, task, things)
        write_verdict(path, found)
    return found


def _with_text(verdict: TaskVerdict, task: Task, things: Library) -> TaskVerdict:
    """A verdict from before there was a check of the text, with that check made."""
    problems = {"text": read_anew(task, things), **verdict.problems}
    return verdict.model_copy(update={"problems": problems})


def _stands(verdict: TaskVerdict, task: Task, depth: CheckDepth) -> bool:
    enough = verdict.solved >= depth.solve and bool(verdict.histories) >= depth.history
    return verdict.digest == digest_of(task) and enough


def _rebuilt(
    suite: Suite, tasks: Sequence[Task], rebuilder: Rebuilder, engine: Engine
) -> dict[str, str]:
    """What is different in tasks that are made again, by id.

    Raises:
        Unfinished: Workers died over some.
    """
    plan, problems = rebuilder.plan(suite, tasks), dict[str, str]()
    with closing(_results("Rebuilding", plan, len(tasks), engine)) as results:
        for task, result in results:
            if result:
                problems[task.id] = result.decode()
    return {task.id: problems[task.id] for task in tasks if task.id in problems}


def _print(
    suite: Suite, verdicts: Sequence[TaskVerdict], changed: dict[str, str], rebuilt: int
) -> None:
    _table(suite.name, verdicts).show()
    said = chain(
        _failures(verdicts),
        _outgrown_lines(verdicts),
        _balance_lines(suite),
        _history_lines(verdicts),
        _observer_lines(verdicts),
    )
    for line in said:
        say(line)
    if rebuilt:
        same = rebuilt - len(changed)
        say(f"{same} of {rebuilt} that were rebuilt from their seeds are the same.")
    for task, problem in changed.items():
        say(f"{task}: rebuilt: {problem}")


def _print_salt(suite: Suite, strange: Sequence[str]) -> None:
    say(f"The salt is the one that {suite.name} is committed to.")
    if not strange:
        say(f"Ids, seeds, letters, forms and order of {len(suite.tasks)} tasks follow from it.")
    say(*strange)


def _table(name: str, verdicts: Sequence[TaskVerdict]) -> ScreenTable:
    table = ScreenTable("type", "tasks", "hold", *CHECKS, title=f"Suite {name}")
    for question_type in sorted({verdict.question_type for verdict in verdicts}):
        mine = [verdict for verdict in verdicts if verdict.question_type == question_type]
        cells = [_passed(check, mine) for check in CHECKS]
        table.add(question_type, str(len(mine)), str(sum(v.holds for v in mine)), *cells)
    return table


def _failures(verdicts: Sequence[TaskVerdict]) -> Iterator[str]:
    for verdict in verdicts:
        for name, problems in verdict.problems.items():
            for problem in problems:
                yield f"{verdict.task}: {name}: {problem}"


def _outgrown_lines(verdicts: Sequence[TaskVerdict]) -> Iterator[str]:
    for verdict in verdicts:
        if verdict.outgrown:
            yield (
                f"{verdict.task}: solvable: today's scripted agents and tools don't solve it; "
                "with the tools that it was made with an attempt did, by its certificate."
            )


def _balance_lines(suite: Suite) -> Iterator[str]:
    for balance in balances(suite.tasks):
        counts = ", ".join(f"{count} {value}" for value, count in balance.counts.items())
        odd = "" if balance.even else " (uneven)"
        yield f"{balance.question_type}, {balance.of}: {counts}{odd}"


def _history_lines(verdicts: Sequence[TaskVerdict]) -> Iterator[str]:
    played = sum(verdict.histories for verdict in verdicts)
    if played:
        share = f"{sum(verdict.reachable for verdict in verdicts)} of {played}"
        yield f"The evidence was within reach after {share} random histories."


def _observer_lines(verdicts: Sequence[TaskVerdict]) -> Iterator[str]:
    for question_type in sorted({verdict.question_type for verdict in verdicts}):
        said = [
            v.observed
            for v in verdicts
            if v.question_type == question_type and v.observed is not None
        ]
        if said:
            right = f"{sum(said)} of {len(said)}"
            yield f"{question_type}: the observer, who only looks, is right in {right}."


def _passed(check: str, verdicts: Sequence[TaskVerdict]) -> str:
    made = [verdict for verdict in verdicts if check in verdict.problems]
    return f"{sum(not v.problems[check] for v in made)}/{len(made)}" if made else "-"
