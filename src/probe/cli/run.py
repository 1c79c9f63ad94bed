"""`probe run`: let an agent or a model work on a suite."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path
from typing import Annotated

import tyro

from probe.agents.external.sandbox import Sandbox
from probe.api.agents import SETTINGS
from probe.api.resources import opener
from probe.cli.dry_run import would_ask
from probe.cli.engines import EngineChoice
from probe.cli.file_agents import who_acts
from probe.cli.metavars import SuiteName
from probe.cli.model_run import ModelRunOptions, run_model
from probe.cli.numbers import check_numbers
from probe.cli.objects import all_objects
from probe.cli.option_conflicts import (
    check_graphs,
    check_pointer,
    check_tools_wanted,
    refuse_stray,
)
from probe.cli.perception import PerceptionChoice
from probe.cli.run_summary import RunSummary, only_json, tell
from probe.cli.running import check_whole, run_order
from probe.cli.shards import parse_shard
from probe.cli.task_choice import TaskChoice
from probe.engines.plan import Engine
from probe.episodes.conditions import AS_FROZEN, Conditions
from probe.episodes.folder import RECORDS
from probe.episodes.participation import Points
from probe.episodes.perceptions import ORACLE_USED, PerceptionUsed, used_by
from probe.episodes.tool_errors import NoiseChoice, tool_errors
from probe.errors import BadData
from probe.perception.choice import Perceiver
from probe.runs.plan import RunOrder
from probe.tasks.suite import Suite
from probe.tasks.suite_file import find_suite
from probe.transcripts.prompts import Graphs, Setting
from probe.types import Shard

_TABLES = 4
"""Samples of a model at a time, if nobody says otherwise: models take their time."""


@dataclass(frozen=True)
class ModelChoice:
    """A model that acts instead of an agent.

    Attributes:
        model: Model that acts instead of an agent: a name of docs/how-to/models.md or the
            harness's own.
        setting: How the model may answer: with tools (the default), with tools and without
            pictures (text-only), or at once from what it is shown.
        graphs: How perceive_scene's lists are told in the setting text-only: "full" (the default)
            as in agentic; "short" for a model whose window is small.
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

    model: Annotated[str | None, tyro.conf.arg(metavar="MODEL")] = None
    setting: Annotated[Setting | None, tyro.conf.arg(aliases=["--arm"])] = None
    graphs: Graphs | None = None
    epochs: Annotated[int | None, tyro.conf.arg(metavar="N")] = None
    points: Points | None = None
    pointer: Annotated[str | None, tyro.conf.arg(metavar="MODEL")] = None
    endpoint: Annotated[str | None, tyro.conf.arg(metavar="URL")] = None
    prices: Annotated[Path | None, tyro.conf.arg(metavar="FILE")] = None
    dry_run: bool = False


@dataclass(frozen=True)
class AgentChoice:
    """Who acts without a model.

    Attributes:
        agent: Who acts, without a model: scripted (the default), random, always-A to always-E,
            always-none, middle-number, question-only, smallest, largest; or your own agent, which
            runs in a separate process (docs/reference/agents.md): "FILE.py:ClassName", or the
            name under which an installed package offers it (entry points "probe.agents").
        agent_name: The name in records of an agent in a file; by default its class's.
        sandbox: What an agent in a file is allowed.
        runs: Episodes of each task, without a model; by default 1.
    """

    agent: Annotated[str | None, tyro.conf.arg(metavar="AGENT")] = None
    agent_name: Annotated[str | None, tyro.conf.arg(metavar="NAME")] = None
    sandbox: Sandbox = Sandbox()
    runs: Annotated[int | None, tyro.conf.arg(metavar="N")] = None


def run(
    suite: SuiteName,
    acting: Annotated[AgentChoice, tyro.conf.arg(name="")] = AgentChoice(),  # noqa: B008
    asked: Annotated[ModelChoice, tyro.conf.arg(name="")] = ModelChoice(),  # noqa: B008
    chosen: Annotated[TaskChoice, tyro.conf.arg(name="")] = TaskChoice(),  # noqa: B008
    out: Annotated[Path, tyro.conf.arg(metavar="FOLDER")] = Path("outputs/run"),
    noise: NoiseChoice = "own",
    workers: Annotated[int | None, tyro.conf.arg(metavar="N")] = None,
    shard: Annotated[str, tyro.conf.arg(metavar="I/N")] = "0/1",
    watch: bool = False,
    where: Annotated[EngineChoice, tyro.conf.arg(name="")] = EngineChoice(),  # noqa: B008
    conditions: Annotated[Conditions, tyro.conf.arg(name="")] = AS_FROZEN,
    seeing: Annotated[PerceptionChoice, tyro.conf.arg(name="")] = PerceptionChoice(),  # noqa: B008
    json: bool = False,
) -> None:
    """Run an agent on the tasks of a suite; continues where an earlier run stopped.

    Args:
        suite: "v2", "v1", "demo" or a file that `probe suite build` wrote.
        acting: Who acts, without a model.
        asked: The model that acts instead.
        chosen: Which tasks; by default all.
        out: Folder for the records.
        noise: How far the hand errs; "paper" fails as often as the paper's. "own": hand and
            detector err as in the suite's headline setting, or not at all if it has none.
        workers: Processes that run episodes; by default 1, for a model 4, and on a cluster one on
            each core.
        where: On which machines.
        watch: Serve a page that shows what the agent sees, calls and is told, as it happens.
        shard: "0/2" and "1/2" on two machines share the work; `probe merge` joins their folders.
        conditions: In what episodes differ from their tasks; see docs/how-to/run.md.
        seeing: What the tools see with; see docs/reference/perception.md.
        json: Print one line of JSON at the end, and all else to standard error.
    """
    part = parse_shard(shard)
    check_numbers({"--runs": acting.runs, "--epochs": asked.epochs, "--workers": workers})
    check_numbers({"--pose-jitter": conditions.pose_jitter})
    if asked.model is not None:
        where.refuse_for_models()
    if watch and where.on != "local":
        reason = "shows tables of this machine alone"
        raise BadData("--watch", reason, "Leave it out, or run without --on")
    seeing.check(conditions)
    tasks, perceiver = chosen.of(find_suite(suite)), seeing.perceiver()
    order = _order(tasks, acting, asked, noise, conditions, used_by(perceiver), part)
    with only_json(json):
        if asked.model is None:
            engine = where.engine(out, workers)
            missing, total = _run_agent(
                tasks, suite, acting, asked, order, out, engine, perceiver, watch=watch
            )
        elif asked.dry_run:
            given = {"--json": json or None, "--watch": watch or None}
            refuse_stray("run", "with --dry-run", given)
            would_ask(tasks, _options_of(acting, asked, order, workers, seeing), out)
            return
        else:
            options = _options_of(acting, asked, order, workers, seeing)
            options = replace(options, perceiver=perceiver, watch=watch)
            missing = run_model(tasks, options, out)
            total = len(options.tasks_of(tasks)) * options.epochs
    records = str(out / RECORDS)
    tell(RunSummary(tasks.name, len(tasks.tasks), total, missing, records), out, as_json=json)
    check_whole(missing, total)


def _order(
    tasks: Suite,
    acting: AgentChoice,
    asked: ModelChoice,
    noise: NoiseChoice,
    conditions: Conditions,
    perception: PerceptionUsed,
    part: Shard,
) -> RunOrder:
    """How a suite is run; who acts is added."""
    oracle = perception == ORACLE_USED and asked.pointer in (None, "oracle")
    setting = asked.setting or SETTINGS.get(acting.agent or "", "agentic")
    hand, conditions = tool_errors(
        tasks.headline, noise, conditions, setting=setting, oracle=oracle
    )
    order = RunOrder("", acting.runs or 1, hand, conditions, part)
    return order if asked.model else replace(order, perception=perception)


def _run_agent(
    tasks: Suite,
    suite: str,
    acting: AgentChoice,
    asked: ModelChoice,
    order: RunOrder,
    out: Path,
    engine: Engine,
    perceiver: Perceiver,
    *,
    watch: bool,
) -> tuple[int, int]:
    """Episodes that are missing by our fault, and all that there are to be.

    Args:
        tasks: What is run.
        suite: Its file, if it is one: it is kept from an agent in a file.
        acting: Who acts.
        asked: Nothing may be said of a model.
        order: How; who acts is added.
        out: Folder for the records.
        engine: Does the episodes.
        perceiver: What the tools see with.
        watch: Whether a page shows it as it happens.
    """
    refuse_stray("run", "without --model", {
        "--setting": asked.setting, "--graphs": asked.graphs,
        "--epochs": asked.epochs, "--points": asked.points,
        "--pointer": asked.pointer, "--endpoint": asked.endpoint, "--prices": asked.prices,
        "--dry-run": asked.dry_run or None,
    })  # fmt: skip
    agent = "scripted" if acting.agent is None else acting.agent
    setting = SETTINGS.get(agent, "agentic")
    check_tools_wanted(order.conditions, setting, f"with --agent {agent}")
    name, agent_of = who_acts(agent, acting.agent_name, acting.sandbox, suite, out)
    order = replace(order, agent=name)
    missing = run_order(tasks, order, agent_of, all_objects(), out, engine, perceiver, watch=watch)
    return missing, len(order.jobs(tasks.tasks))


def _options_of(
    acting: AgentChoice,
    asked: ModelChoice,
    order: RunOrder,
    workers: int | None,
    seeing: PerceptionChoice,
) -> ModelRunOptions:
    """How a model's run is to be.

    Raises:
        BadData: An option would do nothing.
    """
    refuse_stray("run", "with --model", {
        "--agent": acting.agent, "--agent-name": acting.agent_name, "--runs": acting.runs,
        "--sandbox": None if acting.sandbox == Sandbox() else acting.sandbox,
    })  # fmt: skip
    options = ModelRunOptions(
        library=opener(),
        model=asked.model or "",
        setting=asked.setting or "agentic",
        graphs=asked.graphs or "full",
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
    check_graphs(asked.graphs, options.setting)
    check_tools_wanted(options.conditions, options.setting, f"with --setting {options.setting}")
    check_pointer(options.pointer, options.setting, options.conditions)
    seeing.check_model(options.pointer, options.setting)
    return options
