"""`probe tools bench`: how often the tools work, alone, on true targets."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import tyro

from probe.api.resources import Pool, library, opener
from probe.assets.library import Library
from probe.cli.command_app import CommandApp
from probe.cli.engines import EngineChoice
from probe.cli.numbers import check_numbers
from probe.cli.screen import ScreenTable, bar, say
from probe.cli.shards import parse_shard
from probe.episodes.noise import NOISES, NoiseName
from probe.report.tools_page import Failure, write_tools_page
from probe.tool_bench.summary import Summary, drawn_anew, summarise
from probe.tool_bench.trial import Tool, ToolTrial
from probe.tool_bench.work import (
    ToolBenchSettings,
    TrialMaker,
    carry_out,
    picture_path,
    read_trials,
    start,
)
from probe.toolshed.version import TOOLS_VERSION

app = CommandApp()
PAGE = "index.html"


@app.command
def bench(
    out: Path = Path("outputs/tools"),
    pool: Pool = "procedural",
    noise: NoiseName = "none",
    grasps: int = 300,
    pushes: int = 200,
    first_seed: int = 40_000,
    workers: int | None = None,
    where: Annotated[EngineChoice, tyro.conf.arg(name="")] = EngineChoice(),  # noqa: B008
    shard: str = "0/1",
    sigma: float | None = None,
    graspgen: str | None = None,
) -> None:
    """Try grasps and pushes on tables of 15 objects and report how often they work.

    Targets are drawn evenly from what is seen (30 % and 400 pixels), at most five a table; each is
    tried on the same restored table, with its true mask. May be interrupted and run again.

    Args:
        out: Folder for trials, pictures of failures and the page.
        pool: Which objects; scans need PROBE_ASSETS.
        noise: How far the hand errs.
        grasps: Attempts.
        pushes: Attempts.
        first_seed: Of the first table.
        workers: Processes; by default 1, and on a cluster one on each core.
        where: On which machines.
        shard: "0/2" and "1/2" on two machines that see this folder share the work; then run once
            more with "0/1"
            and no attempts for the page of both.
        sigma: Standard deviation of a grasp's error in metres, instead of the noise's own.
        graspgen: Address of a GraspGen server ("tcp://localhost:5556") that proposes the grasps,
            instead of the built-in planner.
    """
    check_numbers({"--grasps": grasps, "--pushes": pushes, "--workers": workers})
    check_numbers({"--first-seed": first_seed, "--sigma": sigma})
    part = parse_shard(shard)
    level = NOISES[noise]
    error = level.grasp if sigma is None else sigma
    settings = ToolBenchSettings(
        pool=pool,
        grasp_noise=error,
        push_noise=level.push,
        first_seed=first_seed,
        graspgen=graspgen,
        tools=TOOLS_VERSION,
    )
    start(out, settings)
    things = library(pool)
    maker, engine = TrialMaker(settings, opener(pool)), where.engine(out, workers)
    with bar() as progress:
        todo: tuple[tuple[Tool, int], ...] = (("grasp", grasps), ("push", pushes))
        for tool, total in todo:
            wanted = -(-total // part.count)
            task = progress.add_task(f"{tool} attempts", total=wanted)
            for count in carry_out(out, tool, wanted, maker, engine, part):
                progress.update(task, completed=count)
    _report(out, settings, things)


def _report(out: Path, settings: ToolBenchSettings, things: Library) -> None:
    trials = read_trials(out)
    summaries: list[Summary] = []
    for tool in ("grasp", "push"):
        some = [trial for trial in trials if trial.tool == tool]
        if some:
            summaries.append(summarise(tool, some))
    error = f"{1000 * settings.grasp_noise:.1f} mm" if settings.grasp_noise else "none"
    title = (
        f"The tools alone, version {settings.tools}: {settings.pool} objects, error of the hand in "
        f"grasps {error}"
    )
    failures = [_failure(trial, things) for trial in trials if not trial.good]
    again, tables = drawn_anew(trials)
    rest = (
        f"Tables drawn again, because something moved when they were rebuilt: {again} of {tables}."
    )
    write_tools_page(out / PAGE, title, rest, summaries, failures)
    for summary in summaries:
        _print(summary)
    say(rest)
    say(f"The page with pictures of {len(failures)} failures is {out / PAGE}")


def _failure(trial: ToolTrial, things: Library) -> Failure:
    asked = "" if trial.distance is None else f" {100 * trial.distance:.0f} cm {trial.direction}"
    went = "" if trial.ratio is None else f", went {100 * trial.ratio:.0f} % of it"
    name = things[trial.object_id].name
    title = f"{trial.tool} {name}{asked}{went} (seed {trial.seed}, {trial.share:.0%} visible)"
    return Failure(title, trial.cause, picture_path(trial))


def _print(summary: Summary) -> None:
    table = ScreenTable("rate", "share", "of n", "95 % by scene", title=summary.tool)
    for rate in summary.rates:
        interval = f"{rate.low:.0%} to {rate.high:.0%}"
        table.add(rate.name, f"{rate.share:.1%}", f"{rate.held} of {rate.n}", interval)
    for name, median, most in summary.seconds:
        table.add(f"{name}, CPU s", f"{median:.2f}", "", f"p95 {most:.2f}")
    table.show()
    say("outcomes: " + ", ".join(f"{cause} {n}" for cause, n in summary.causes))
