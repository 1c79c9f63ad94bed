"""Running a suite with a bar that says how far it is; for `probe run` and `probe demo`."""

from __future__ import annotations

from contextlib import closing
from pathlib import Path

from probe.api.resources import everything
from probe.assets.library import Library
from probe.cli.checksum_notice import tell_unsummed
from probe.cli.objects import check
from probe.cli.screen import bar, say, say_above
from probe.cli.variation import varied
from probe.cli.watching import watching
from probe.engines.plan import Engine
from probe.episodes.folder import RECORDS
from probe.errors import Unfinished
from probe.perception.choice import Perceiver, ideal
from probe.runs.plan import RunOrder
from probe.runs.run import RunStart, begun, check_folder, work
from probe.runs.vary import changes_scenes
from probe.runs.work import AgentOf, WorkerSetup
from probe.tasks.suite import Suite

AGAIN = "The same command tries them again."


def run_order(
    suite: Suite,
    order: RunOrder,
    agent_of: AgentOf,
    things: Library,
    out: Path,
    engine: Engine,
    perceiver: Perceiver = ideal,
    *,
    watch: bool = False,
) -> int:
    """Add the records that a folder doesn't hold yet, and the suite they are about.

    Args:
        suite: As it is to be run; its objects are checked.
        order: Which episodes.
        agent_of: Makes agents in a worker process.
        things: Has the suite's objects; each worker opens it itself.
        out: Folder for the records.
        engine: Does the episodes.
        perceiver: What the tools see with; the order says the same.
        watch: Whether a page shows the tables as long as it lasts.

    Returns:
        How many episodes are missing by our fault.

    Raises:
        BadData: What is there was run under other conditions, or is about another suite.
    """
    if not changes_scenes(order.conditions):
        check_folder(out, suite, order)
    check(suite, things)
    if changes_scenes(order.conditions):
        suite = varied(suite, order.conditions, things, out)
    faults = 0
    with begun(out, suite, order) as beginning:
        _tell(beginning, out)
        total = len(beginning.jobs) + beginning.done
        with (
            watching(out, suite, order.agent, order.setting, total, on=watch) as tables,
            bar() as progress,
            closing(
                work(
                    out,
                    beginning,
                    WorkerSetup(order, everything, agent_of, perceiver, tables),
                    engine,
                )
            ) as results,
        ):
            doing = f"{order.agent} at work"
            line = progress.add_task(doing, total=total, completed=beginning.done)
            for job, fault in results:
                if fault is not None:
                    faults += 1
                    say_above(progress, f"{job.task.id}, run {job.run} is missing: {fault}")
                more = f", {faults} missing" if faults else ""
                progress.update(line, advance=1, description=doing + more)
    return faults


def check_whole(missing: int, total: int) -> None:
    """End with a failure if episodes are missing.

    Raises:
        Unfinished: They are.
    """
    if missing:
        raise Unfinished(missing, total, "episodes", AGAIN)


def _tell(beginning: RunStart, out: Path) -> None:
    say(f"Records go to {out / RECORDS}; Ctrl-C stops, the same command goes on.")
    if beginning.cut:
        say(f"Its last record was cut off: moved to {beginning.cut}, and run again.")
    tell_unsummed(out)
    if beginning.done:
        say(f"{beginning.done} episodes were there already.")
