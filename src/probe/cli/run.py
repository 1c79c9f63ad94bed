"""`probe run`: let an agent or a model work on a suite."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path
from typing import Annotated

import tyro

from probe.agents.external.sandbox import Sandbox
from probe.api.agents import AgentName
from probe.api.resources import everything, opener
from probe.cli.dry_run import would_ask
from probe.cli.engines import EngineChoice
from probe.cli.file_agents import who_acts
from probe.cli.model_run import ModelRunOptions, run_model
from probe.cli.numbers import check_numbers
from probe.cli.option_conflicts import check_pointer, refuse_stray
from probe.cli.running import check_whole, run_order
from probe.cli.screen import say
from probe.cli.shards import parse_shard
from probe.engines.plan import Engine
from probe.episodes.conditions import AS_FROZEN, Conditions
from probe.episodes.folder import RECORDS
from probe.episodes.noise import NOISES, NoiseName
from probe.episodes.participation import Points
from probe.errors import BadData
from probe.runs.plan import RunOrder
from probe.tasks.suite_file import find_suite
from probe.transcripts.prompts import Setting

_TABLES = 4
"""Samples of a model at a time, if nobody says otherwise: models take their time."""


@dataclass(frozen=True)
class ModelChoice:
    """A model that acts instead of an agent.

    Attributes:
        model: Model that acts instead of an agent: a name of docs/how-to/models.md or the
            harness's own.
        setting: How the model may answer: with tools (the default), or at once from what it is
            shown.
        epochs: Episodes of each task, for a model; by default 3.
        points: How the model writes coordinates: pixels, or thousandths of the picture's sides. By
            default what suits a model with a short name, and pixels for any other.
        pointer: Who points for perception: "oracle" (the default) for nobody, "self" for the
            model, or the name of another.
        endpoint: Address of a server that speaks OpenAI's protocol, version included, such as
            http://localhost:8000/v1.
        prices: A file with the prices of tokens.
        dry_run: Send nothing; only count replies, pictures and tokens.
    """

    model: str | None = None
    setting: Annotated[Setting | None, tyro.conf.arg(aliases=["--arm"])] = None
    epochs: int | None = None
    points: Points | None = None
    pointer: str | None = None
    endpoint: str | None = None
    prices: Path | None = None
    dry_run: bool = False


@dataclass(frozen=True)
class AgentChoice:
    """Who acts without a model.

    Attributes:
        agent: Who acts, without a model; by default "scripted". "FILE.py:ClassName" for your
            own agent, which runs in a separate process: see docs/reference/agents.md.
        agent_name: The name in records of an agent in a file; by default its class's.
        sandbox: What an agent in a file is allowed.
        runs: Episodes of each task, without a model; by default 1.
    """

    agent: AgentName | str | None = None
    agent_name: str | None = None
    sandbox: Sandbox = Sandbox()
    runs: int | None = None


def run(
    suite: Annotated[str, tyro.conf.Positional],
    acting: Annotated[AgentChoice, tyro.conf.arg(name="")] = AgentChoice(),  # noqa: B008
    asked: Annotated[ModelChoice, tyro.conf.arg(name="")] = ModelChoice(),  # noqa: B008
    out: Path = Path("outputs/run"),
    noise: NoiseName = "none",
    workers: int | None = None,
    shard: str = "0/1",
    where: Annotated[EngineChoice, tyro.conf.arg(name="")] = EngineChoice(),  # noqa: B008
    conditions: Annotated[Conditions, tyro.conf.arg(name="")] = AS_FROZEN,
) -> None:
    """Run an agent on every task of a suite; continues where an earlier run stopped.

    Args:
        suite: "v1", "demo" or a file that `probe suite build` wrote.
        acting: Who acts, without a model.
        asked: The model that acts instead.
        out: Folder for the records.
        noise: How far the hand errs; "paper" fails as often as the paper's.
        workers: Processes that run episodes; by default 1, for a model 4, and on a cluster one on
            each core.
        where: On which machines.
        shard: "0/2" and "1/2" on two machines share the work; `probe merge` joins their folders.
        conditions: In what episodes differ from their tasks; see docs/how-to/run.md.
    """
    part = parse_shard(shard)
    check_numbers({"--runs": acting.runs, "--epochs": asked.epochs, "--workers": workers})
    check_numbers({"--pose-jitter": conditions.pose_jitter})
    order = RunOrder("", acting.runs or 1, NOISES[noise], conditions, part)
    if asked.model is None:
        missing, total = _run_agent(suite, acting, asked, order, out, where.engine(out, workers))
    elif where != EngineChoice():
        remedy = "Use --shard I/N on each machine, and probe merge"
        raise BadData("--on", "models are asked from one machine", remedy)
    elif asked.dry_run:
        would_ask(find_suite(suite), _options_of(acting, asked, order, workers), out)
        return
    else:
        options = _options_of(acting, asked, order, workers)
        tasks = find_suite(suite)
        missing = run_model(tasks, options, out)
        total = len(options.tasks_of(tasks)) * options.epochs
    say(f"Records are in {out / RECORDS}; `probe report {out}` shows them.")
    check_whole(missing, total)


def _run_agent(
    suite: str, acting: AgentChoice, asked: ModelChoice, order: RunOrder, out: Path, engine: Engine
) -> tuple[int, int]:
    """Episodes that are missing by our fault, and all that there are to be."""
    refuse_stray("without --model", {
        "--setting": asked.setting, "--epochs": asked.epochs, "--points": asked.points,
        "--pointer": asked.pointer, "--endpoint": asked.endpoint, "--prices": asked.prices,
        "--dry-run": asked.dry_run or None,
    })  # fmt: skip
    tasks, things = find_suite(suite), everything()
    agent = "scripted" if acting.agent is None else acting.agent
    name, agent_of = who_acts(agent, acting.agent_name, acting.sandbox, suite, out)
    order = replace(order, agent=name)
    missing = run_order(tasks, order, agent_of, things, out, engine)
    return missing, len(order.jobs(tasks.tasks))


def _options_of(
    acting: AgentChoice, asked: ModelChoice, order: RunOrder, workers: int | None
) -> ModelRunOptions:
    """How a model's run is to be.

    Raises:
        BadData: An option would do nothing.
    """
    refuse_stray("with --model", {
        "--agent": acting.agent, "--agent-name": acting.agent_name, "--runs": acting.runs,
        "--sandbox": None if acting.sandbox == Sandbox() else acting.sandbox,
    })  # fmt: skip
    options = ModelRunOptions(
        library=opener(),
        model=asked.model or "",
        setting=asked.setting or "agentic",
        epochs=asked.epochs or 3,
        points=asked.points,
        pointer="oracle" if asked.pointer is None else asked.pointer,
        endpoint=asked.endpoint,
        prices=asked.prices,
        noise=order.noise,
        conditions=order.conditions,
        shard=order.shard,
        workers=workers or _TABLES,
    )
    check_pointer(options.pointer, options.setting, options.conditions)
    return options
