"""Running a suite with a bar that says how far it is; for `probe run` and `probe demo`."""

from __future__ import annotations

from contextlib import closing
from functools import partial
from pathlib import Path

from rich.progress import track

from probe.assets.library import Library, open_library
from probe.cli.bars import bar
from probe.cli.surroundings import cache_folder
from probe.episodes.conditions import Conditions
from probe.episodes.folder import RECORDS
from probe.render.renderer import Renderer
from probe.runs.plan import Order
from probe.runs.run import Beginning, begun, work
from probe.runs.variation import Variation, earlier, keep_varied, read_variation
from probe.runs.vary import changes_scenes, vary
from probe.runs.work import AgentOf, Workplace
from probe.tasks.suite import Suite, check_objects


def run_order(
    suite: Suite, order: Order, agent_of: AgentOf, things: Library, out: Path, workers: int = 1
) -> None:
    """Add the records that a folder doesn't hold yet, and the suite they are about.

    Args:
        suite: As it is to be run; its objects are checked.
        order: Which episodes.
        agent_of: Makes agents in a worker process.
        things: Has the suite's objects; workers open it anew.
        out: Folder for the records.
        workers: Processes.

    Raises:
        BadData: What is there was run under other conditions, or is about another suite.
    """
    check_objects(suite, things)
    if changes_scenes(order.conditions):
        suite = _varied(suite, order.conditions, things, out)
    pool = "all" if things.assets else "procedural"
    library = partial(open_library, pool, things.assets, things.cache)
    place = Workplace(order, library, agent_of, cache_folder() / "light")
    with begun(out, suite, order) as beginning:
        _tell(beginning, out)
        with bar() as progress, closing(work(out, beginning.jobs, place, workers)) as results:
            doing = f"{order.agent} at work"
            total = len(beginning.jobs) + beginning.done
            line = progress.add_task(doing, total=total, completed=beginning.done)
            faults = 0
            for job, fault in results:
                if fault is not None:
                    faults += 1
                    progress.console.print(f"{job.task.id}, run {job.run} is missing: {fault}")
                more = f", {faults} missing" if faults else ""
                progress.update(line, advance=1, description=doing + more)


def _varied(base: Suite, conditions: Conditions, things: Library, out: Path) -> Suite:
    """The suite under other conditions, as the folder has it or made now; says what is amiss."""
    suite = earlier(out, base, conditions)
    if suite is None:
        with Renderer() as renderer:
            made = vary(base.tasks, conditions, things, renderer)
            total = len(base.tasks)
            found = list(track(made, f"Preparing tables ({conditions.label})", total=total))
        suite = keep_varied(out, base, conditions, found)
    notes = (read_variation(out) or Variation(base="", conditions="", notes={})).notes
    for task, note in notes.items():
        print(f"{task}: {note}")
    print(f"{len(notes)} of {len(base.tasks)} tasks are no longer what was certified; all are run.")
    return suite


def _tell(beginning: Beginning, out: Path) -> None:
    print(f"Records go to {out / RECORDS}; Ctrl-C stops, the same command goes on.")
    if beginning.cut:
        print(f"Its last record was cut off: moved to {beginning.cut}, and run again.")
    if beginning.done:
        print(f"{beginning.done} episodes were there already.")
