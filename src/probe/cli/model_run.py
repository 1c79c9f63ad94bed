"""A model in the seat, for `probe run --model`: what is run, and how much that asks of it."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path

from probe.api.resources import cache_folder
from probe.assets.library import Library
from probe.bench.models import asked_as, settings_of
from probe.bench.plan import ModelRunPlan
from probe.bench.prices import Price, Prices, read_prices
from probe.cli.address import check_address
from probe.cli.listening import check_listening
from probe.cli.objects import check
from probe.cli.screen import say, sign
from probe.cli.variation import varied
from probe.cli.watching import watching
from probe.episodes.conditions import Conditions
from probe.episodes.folder import check_suite
from probe.episodes.noise import Noise
from probe.episodes.participation import Points
from probe.errors import BadData, MissingExtra
from probe.files import check_writable
from probe.perception.choice import Perceiver, ideal
from probe.runs.vary import changes_scenes
from probe.tasks.suite import Suite
from probe.tasks.task import Task
from probe.transcripts.prompts import Graphs, Setting
from probe.types import Shard


@dataclass(frozen=True, kw_only=True)
class ModelRunOptions:
    """What is to be run, as the command line has it; see probe.cli.run.run.

    Attributes:
        library: Opens the objects; a value that can be sent to another process.
        watch: Whether a page shows the tables as long as it lasts.
    """

    library: Callable[[], Library]
    model: str
    setting: Setting
    epochs: int
    points: Points | None
    pointer: str
    endpoint: str | None
    prices: Path | None
    noise: Noise
    conditions: Conditions
    shard: Shard
    workers: int
    graphs: Graphs = "full"
    perceiver: Perceiver = ideal
    watch: bool = False

    @property
    def counting(self) -> Points:
        """How the model counts places."""
        return self.points or settings_of(self.model).points

    def tasks_of(self, suite: Suite) -> tuple[Task, ...]:
        """Those that this shard runs, all their epochs."""
        return tuple(suite.tasks[self.shard.number :: self.shard.count])


def run_model(suite: Suite, options: ModelRunOptions, out: Path, *, plain: bool = False) -> int:
    """Run a suite with a model.

    Args:
        suite: What is asked.
        options: Which model is asked, and how.
        out: Folder of the records.
        plain: Print lines even to a terminal, where a bar of the caller's stands.

    Returns:
        How many episodes are missing by our fault.

    Raises:
        MissingExtra: The harness isn't installed.
        BadData: The folder is about something else, prices can't be read, or nobody has the model.
        ModelFailed: Nobody answers at its address.
    """
    check_asked(options)
    price = price_of(options.prices, options.model)
    for name in {options.model, options.pointer} - {"oracle", "self"}:
        if options.endpoint is None:
            _check_served(name)
    check_listening(options.model, options.endpoint)
    if not changes_scenes(options.conditions):
        check_suite(out, suite)
    check_writable(out)
    with sign("Reading the catalogue of objects ..."):
        things = options.library()
    check(suite, things)
    if changes_scenes(options.conditions):
        suite = varied(suite, options.conditions, things, out)
    try:
        with sign("Loading the harness for models ..."):
            from probe.bench.evaluation import Participants, evaluate
    except ImportError as error:
        raise MissingExtra("A model in the seat", "bench") from error
    plan = plan_of(suite, options, out, price)
    key = os.environ.get("OPENAI_API_KEY") or "none"
    pointer = settings_of(options.pointer).id if plan.pointer == "role" else None
    its_price = price_of(options.prices, options.pointer) if pointer else None
    chosen = Participants(settings_of(options.model).id, options.endpoint, key, pointer, its_price)
    total = len(plan.tasks) * plan.epochs
    setting = plan.order(options.model, pointer_name(options)).setting
    with watching(out, suite, options.model, setting, total, on=options.watch) as tables:
        plan = replace(plan, tables=tables)
        return evaluate(plan, chosen, "rich" if sys.stdout.isatty() and not plain else "plain")


def price_of(path: Path | None, name: str) -> Price | None:
    """Of a model's tokens; says so if there is a file of prices and its isn't among them.

    Raises:
        BadData: The file can't be read.
    """
    if path is None:
        return None
    prices: Prices = read_prices(path)
    price = prices.get(name) or prices.get(settings_of(name).id)
    if price is None:
        known = ", ".join(sorted(prices)) or "none"
        say(f"{path} has no price of {name}: no cost is told. Known: {known}.")
    return price


def pointer_name(options: ModelRunOptions) -> str:
    """Of the one that points, as records have it; empty for nobody."""
    if options.pointer == "oracle":
        return ""
    if options.pointer == "self":
        return "self"
    pointer, acting = settings_of(options.pointer).id, settings_of(options.model).id
    return asked_as(pointer, acting, options.endpoint)


def check_asked(options: ModelRunOptions) -> None:
    """See that models have names, and the server an address.

    Raises:
        BadData: One hasn't.
    """
    check_address(options.endpoint)
    for option, name in (("--model", options.model), ("--pointer", options.pointer)):
        if not name.strip():
            raise BadData(option, "is empty", "Say the name of a model")


def _check_served(name: str) -> None:
    """See that a model needs no --endpoint.

    Raises:
        BadData: It does.
    """
    known = settings_of(name)
    where = "--endpoint, such as http://localhost:8000/v1"
    if known.serve is not None and "VLLM_BASE_URL" not in os.environ:
        remedy = f"Start a server of its weights ({known.serve}) and say its address with {where}"
        raise BadData(name, "has no server of its own", remedy)
    if "/" not in known.id:
        remedy = f"Say where its server is with {where}, or a name such as openai/{name}"
        raise BadData(name, "is no short name, and names no provider", remedy)


def plan_of(suite: Suite, options: ModelRunOptions, out: Path, price: Price | None) -> ModelRunPlan:
    """What is run, in the terms of `probe.bench`."""
    pointing = settings_of(options.model if options.pointer == "self" else options.pointer)
    return ModelRunPlan(
        setting=options.setting,
        suite=suite,
        tasks=options.tasks_of(suite),
        out=out,
        library=options.library,
        cache=cache_folder() / "light",
        epochs=options.epochs,
        points=options.counting,
        noise=options.noise,
        conditions=options.conditions,
        pointer=options.pointer if options.pointer in ("oracle", "self") else "role",
        convention=pointing.pointing,
        workers=options.workers,
        prices={options.model: price} if price else {},
        called=options.model,
        perceiver=options.perceiver,
        graphs=options.graphs,
    )
