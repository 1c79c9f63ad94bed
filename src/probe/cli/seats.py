"""A model in the seat, for `probe run --model`: what is run, and how much that asks of it."""

from __future__ import annotations

import os
import sys
from dataclasses import dataclass
from functools import partial
from pathlib import Path

from probe.assets.library import open_all
from probe.bench.estimate import PICTURE_TOKENS, Estimate, estimate
from probe.bench.models import settings_of
from probe.bench.plan import Plan
from probe.bench.prices import Price, Prices, read_prices
from probe.chat.prompts import Arm
from probe.cli.pointers import check_addresses
from probe.cli.surroundings import assets_folder, cache_folder, everything
from probe.cli.varying import varied
from probe.episodes.conditions import Conditions
from probe.episodes.luck import Noise
from probe.episodes.seat import Points
from probe.errors import MissingExtra
from probe.runs.plan import Shard
from probe.runs.vary import changes_scenes
from probe.tasks.suite import Suite, check_objects
from probe.tasks.task import Task
from probe.toolshed.toolshed import TURNS


@dataclass(frozen=True)
class Seats:
    """What is to be run, as the command line has it; see probe.cli.run.run."""

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
        BadData: The folder is about something else, prices can't be read, or options don't fit.
    """
    check_addresses(seats.arm, seats.pointer, seats.endpoint)
    prices: Prices = read_prices(seats.prices) if seats.prices else {}
    price = prices.get(seats.model) or prices.get(settings_of(seats.model).id)
    if dry_run:
        _tell(suite, seats, price)
        if seats.pointer != "oracle":
            print(f"Replies that point ({seats.pointer}) come on top and aren't in these figures.")
        return
    things = everything()
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
    its_price = prices.get(seats.pointer) or prices.get(pointer or "")
    chosen = Chosen(settings_of(seats.model).id, seats.endpoint, key, pointer, its_price)
    missing = evaluate(plan, chosen, "rich" if sys.stdout.isatty() else "plain")
    if missing:
        print(f"{missing} episodes are missing; the same command tries them again.")


def _plan(suite: Suite, seats: Seats, out: Path, price: Price | None) -> Plan:
    pointing = settings_of(seats.model if seats.pointer == "self" else seats.pointer)
    return Plan(
        arm=seats.arm,
        suite=suite,
        tasks=seats.tasks_of(suite),
        out=out,
        library=partial(open_all, assets_folder(), cache_folder()),
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


def _tell(suite: Suite, seats: Seats, price: Price | None) -> None:
    tasks = seats.tasks_of(suite)
    usual = estimate(seats.arm, seats.counting, tasks, seats.epochs)
    print(f"{len(tasks)} tasks, {seats.epochs} runs each: {usual.episodes} episodes.")
    print(_line("If they are of usual length", usual, price))
    if seats.arm == "agentic":
        most = estimate(seats.arm, seats.counting, tasks, seats.epochs, TURNS)
        print(_line(f"At most ({TURNS} calls each)", most, price))
    print(f"Pictures are taken for {PICTURE_TOKENS} tokens each; nothing was asked.")


def _line(when: str, found: Estimate, price: Price | None) -> str:
    cost = ""
    if price is not None:
        dollars = found.tokens_in * price.tokens_in + found.tokens_out * price.tokens_out
        cost = f", {dollars / 1e6:,.2f} US dollars"
    asked = f"{found.replies:,} replies, {found.pictures:,} pictures sent"
    tokens = f"{found.tokens_in / 1e6:,.1f} million tokens in and {found.tokens_out / 1e6:,.2f} out"
    return f"{when}: {asked}, about {tokens}{cost}."
