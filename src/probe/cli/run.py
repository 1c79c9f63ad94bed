"""`probe run`: let an agent or a model work on a suite."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import tyro

from probe.agents.external.sandbox import Sandbox
from probe.api.agents import AgentName
from probe.api.resources import everything, opener
from probe.cli.dry_run import would_ask
from probe.cli.file_agents import who_acts
from probe.cli.model_run import ModelRunOptions, take_seats
from probe.cli.numbers import check_numbers
from probe.cli.option_conflicts import check_pointer, refuse_stray
from probe.cli.running import check_whole, run_order
from probe.cli.screen import say
from probe.cli.shards import parse_shard
from probe.episodes.conditions import AS_FROZEN, Conditions
from probe.episodes.folder import RECORDS
from probe.episodes.noise import NOISES, NoiseName
from probe.episodes.participation import Points
from probe.runs.plan import RunOrder
from probe.tasks.suite_file import find_suite
from probe.transcripts.prompts import Setting

_TABLES = 4
"""Samples of a model at a time, if nobody says otherwise: models take their time."""


def run(
    suite: Annotated[str, tyro.conf.Positional],
    agent: AgentName | str | None = None,
    agent_name: str | None = None,
    sandbox: Sandbox = Sandbox(),  # noqa: B008 - a value
    out: Path = Path("outputs/run"),
    runs: int | None = None,
    noise: NoiseName = "none",
    workers: int | None = None,
    shard: str = "0/1",
    conditions: Annotated[Conditions, tyro.conf.arg(name="")] = AS_FROZEN,
    model: str | None = None,
    setting: Annotated[Setting | None, tyro.conf.arg(aliases=["--arm"])] = None,
    epochs: int | None = None,
    points: Points | None = None,
    pointer: str | None = None,
    endpoint: str | None = None,
    prices: Path | None = None,
    dry_run: bool = False,
) -> None:
    """Let an agent work on every task of a suite; goes on where an earlier run stopped.

    Args:
        suite: "v1", "demo" or a file that `probe suite build` wrote.
        agent: Who acts, without a model; by default "scripted". "FILE.py:ClassName" for an agent of
            your own, which runs in a process of its own: see docs/reference/agents.md.
        agent_name: What records call an agent of a file; by default as its class.
        sandbox: What an agent of a file is allowed.
        out: Folder for the records.
        runs: Episodes of each task, for agents without a model; by default 1.
        noise: How far the hand errs; "paper" fails as often as the paper's.
        workers: Processes that run episodes; by default 1, for a model 4.
        shard: "0/2" and "1/2" on two machines share the work; `probe merge` joins their folders.
        conditions: In what episodes differ from their tasks; see docs/how-to/run.md.
        model: A model that acts instead, by a name of docs/how-to/models.md or the harness's
            own.
        setting: How the model may answer: with tools (the default), or at once from what it is
            shown.
        epochs: Episodes of each task, for a model; by default 3.
        points: How the model counts places in pictures; by default what suits it.
        pointer: Who points for perception: "oracle" (the default) for nobody, "self" for the
            model, or the name of another.
        endpoint: Address of a server that speaks OpenAI's protocol, up to and with its version.
        prices: A file that says what tokens cost.
        dry_run: Only say how much would be asked of the model.
    """
    part = parse_shard(shard)
    check_numbers({"--runs": runs, "--epochs": epochs, "--workers": workers})
    check_numbers({"--pose-jitter": conditions.pose_jitter})
    if model is None:
        refuse_stray("without --model", {
            "--setting": setting, "--epochs": epochs, "--points": points, "--pointer": pointer,
            "--endpoint": endpoint, "--prices": prices, "--dry-run": dry_run or None,
        })  # fmt: skip
        asked, things = find_suite(suite), everything()
        name, agent_of = who_acts(
            "scripted" if agent is None else agent, agent_name, sandbox, suite, out
        )
        order = RunOrder(name, runs or 1, NOISES[noise], conditions, part)
        missing = run_order(asked, order, agent_of, things, out, workers or 1)
        total = len(order.jobs(asked.tasks))
    else:
        refuse_stray("with --model", {
            "--agent": agent, "--agent-name": agent_name, "--runs": runs,
            "--sandbox": None if sandbox == Sandbox() else sandbox,
        })  # fmt: skip
        pointer = "oracle" if pointer is None else pointer
        check_pointer(pointer, setting or "agentic", conditions)
        seats = ModelRunOptions(
            library=opener(),
            model=model,
            setting=setting or "agentic",
            epochs=epochs or 3,
            points=points,
            pointer=pointer,
            endpoint=endpoint,
            prices=prices,
            noise=NOISES[noise],
            conditions=conditions,
            shard=part,
            workers=workers or _TABLES,
        )
        asked = find_suite(suite)
        if dry_run:
            would_ask(asked, seats, out)
            return
        missing = take_seats(asked, seats, out)
        total = len(seats.tasks_of(asked)) * seats.epochs
    say(f"Records are in {out / RECORDS}; `probe report {out}` shows them.")
    check_whole(missing, total)
