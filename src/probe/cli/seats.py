"""A model in the seat, for `probe run --model`: what is run, and how much that asks of it."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from probe.assets.library import Library
from probe.bench.estimate import PICTURE_TOKENS, REPLY_TOKENS, Estimate, estimate
from probe.bench.models import settings_of
from probe.bench.plan import Plan
from probe.bench.prices import Price, Prices, read_prices
from probe.chat.prompts import Arm
from probe.cli.surroundings import cache_folder
from probe.cli.varying import varied
from probe.episodes.conditions import Conditions
from probe.episodes.files import read_records
from probe.episodes.folder import RECORDS
from probe.episodes.luck import Noise
from probe.episodes.seat import Points
from probe.errors import BadData, MissingExtra
from probe.runs.plan import Shard
from probe.runs.vary import changes_scenes
from probe.tasks.suite import Suite, check_objects
from probe.tasks.task import Task
from probe.toolshed.toolshed import TURNS


@dataclass(frozen=True, kw_only=True)
class Seats:
    """What is to be run, as the command line has it; see probe.cli.run.run.

    Attributes:
        library: Opens the objects; a value that can be sent to another process.
    """

    library: Callable[[], Library]
    model: str
    arm: Arm
    epochs: int
    points: Points | None
    pointer: str
    endpoint: str | None
    prices: Path | None
    noise: Noise
    conditions: Conditions
    shard: Shard
    workers: int

    @property
    def counting(self) -> Points:
        """How the model counts places."""
        return self.points or settings_of(self.model).points

    def tasks_of(self, suite: Suite) -> tuple[Task, ...]:
        """Those that this shard runs, all their epochs."""
        return tuple(suite.tasks[self.shard.number :: self.shard.count])


def take_seats(suite: Suite, seats: Seats, out: Path, *, dry_run: bool) -> None:
    """Run a suite with a model, or say what that would ask of it.

    Raises:
        MissingExtra: The harness isn't installed.
        BadData: The folder is about something else, prices can't be read, or nobody has the model.
    """
    _check_address(seats.endpoint)
    price = _price_of(seats, seats.model)
    if dry_run:
        _tell(suite, seats, out, price)
        if seats.pointer != "oracle":
            print(f"Replies that point ({seats.pointer}) come on top and aren't in these figures.")
        return
    for name in {seats.model, seats.pointer} - {"oracle", "self"}:
        if seats.endpoint is None:
            _check_served(name)
    things = seats.library()
    check_objects(suite, things)
    if changes_scenes(seats.conditions):
        suite = varied(suite, seats.conditions, things, out)
    try:
        from probe.bench.evaluation import Chosen, evaluate
    except ImportError as error:
        raise MissingExtra("A model in the seat", "bench") from error
    plan = _plan(suite, seats, out, price)
    key = os.environ.get("OPENAI_API_KEY") or "none"
    pointer = settings_of(seats.pointer).id if plan.pointer == "role" else None
    its_price = _price_of(seats, seats.pointer) if pointer else None
    chosen = Chosen(settings_of(seats.model).id, seats.endpoint, key, pointer, its_price)
    missing = evaluate(plan, chosen, "rich" if sys.stdout.isatty() else "plain")
    if missing:
        print(f"{missing} episodes are missing; the same command tries them again.")


def _price_of(seats: Seats, name: str) -> Price | None:
    """Of a model's tokens; says so if prices were given and its isn't among them."""
    if seats.prices is None:
        return None
    prices: Prices = read_prices(seats.prices)
    price = prices.get(name) or prices.get(settings_of(name).id)
    if price is None:
        known = ", ".join(sorted(prices)) or "none"
        print(f"{seats.prices} has no price of {name}: no cost is told. Known: {known}.")
    return price


def _check_address(endpoint: str | None) -> None:
    """See that it is one.

    Raises:
        BadData: It isn't.
    """
    if endpoint is not None and not endpoint.startswith(("http://", "https://")):
        remedy = "Begin it with http:// or https://"
        raise BadData("--endpoint", f"{endpoint!r} is no address of a server", remedy)


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


def _plan(suite: Suite, seats: Seats, out: Path, price: Price | None) -> Plan:
    pointing = settings_of(seats.model if seats.pointer == "self" else seats.pointer)
    return Plan(
        arm=seats.arm,
        suite=suite,
        tasks=seats.tasks_of(suite),
        out=out,
        library=seats.library,
        cache=cache_folder() / "light",
        epochs=seats.epochs,
        points=seats.counting,
        noise=seats.noise,
        conditions=seats.conditions,
        pointer=seats.pointer if seats.pointer in ("oracle", "self") else "role",
        convention=pointing.pointing,
        workers=seats.workers,
        prices={seats.model: price} if price else {},
        called=seats.model,
    )


def _tell(suite: Suite, seats: Seats, out: Path, price: Price | None) -> None:
    tasks = seats.tasks_of(suite)
    whole = len(tasks) * seats.epochs
    print(f"{len(tasks)} tasks, {seats.epochs} runs each: {whole} episodes.")
    done = _done(suite, seats, out)
    left = [task for task in tasks for run in range(seats.epochs) if (task.id, run) not in done]
    if len(left) < whole:
        print(f"{whole - len(left)} of them are in {out} already; what follows is of the others.")
    usual = estimate(seats.arm, seats.counting, left, 1)
    print(_line("If they are of usual length", usual, price))
    if seats.arm == "agentic":
        longest = estimate(seats.arm, seats.counting, left, 1, TURNS)
        print(_line(f"If each takes all {TURNS} calls", longest, price))
    print(
        f"Pictures are taken for {PICTURE_TOKENS} tokens each, replies for {REPLY_TOKENS}: a model "
        "that reasons may write thousands, which cost as replies do. Nothing was asked."
    )


def _done(suite: Suite, seats: Seats, out: Path) -> set[tuple[str, int]]:
    """Episodes that the folder holds, by task and run."""
    path = out / RECORDS
    pointer = "self" if seats.pointer == "self" else settings_of(seats.pointer).id
    order = _plan(suite, seats, out, None).order(
        seats.model, "" if seats.pointer == "oracle" else pointer
    )
    records = read_records(path, whole=False) if path.exists() else []
    mine = [it for it in records if (it.agent, it.arm) == (order.agent, order.arm)]
    return {(it.task, it.run) for it in mine if it.end != "fault"}


def _line(when: str, found: Estimate, price: Price | None) -> str:
    cost = ""
    if price is not None:
        dollars = found.tokens_in * price.tokens_in + found.tokens_out * price.tokens_out
        cost = f", {dollars / 1e6:,.2f} US dollars"
    asked = f"{found.replies:,} replies, {found.pictures:,} pictures sent"
    tokens = f"{found.tokens_in / 1e6:,.1f} million tokens in and {found.tokens_out / 1e6:,.2f} out"
    return f"{when}: {asked}, about {tokens}{cost}."
