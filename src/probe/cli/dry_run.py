"""How much a run with a model would ask of it, for `probe run --model --dry-run`."""

from __future__ import annotations

from pathlib import Path

from probe.bench.estimate import PICTURE_TOKENS, REPLY_TOKENS, Estimate, estimate
from probe.bench.prices import Price
from probe.cli.model_run import ModelRunOptions, check_asked, plan_of, pointer_name, price_of
from probe.cli.screen import say
from probe.episodes.files import read_records
from probe.episodes.folder import RECORDS
from probe.episodes.participation import has_tools
from probe.tasks.suite import Suite
from probe.texts import plural
from probe.toolshed.toolshed import TURNS


def would_ask(suite: Suite, options: ModelRunOptions, out: Path) -> None:
    """Say how much it is; asks nothing.

    Raises:
        BadData: Prices can't be read, or the folder can't.
    """
    check_asked(options)
    _tell(suite, options, out, price_of(options.prices, options.model))
    if options.pointer != "oracle":
        say(f"Replies that point ({options.pointer}) come on top and aren't in these figures.")


def _tell(suite: Suite, options: ModelRunOptions, out: Path, price: Price | None) -> None:
    tasks = options.tasks_of(suite)
    whole = len(tasks) * options.epochs
    say(
        f"{plural(len(tasks), 'task')}, {plural(options.epochs, 'run')} each: "
        f"{plural(whole, 'episode')}."
    )
    done = _done(suite, options, out)
    left = [task for task in tasks for run in range(options.epochs) if (task.id, run) not in done]
    if len(left) < whole:
        say(f"{whole - len(left)} of them are in {out} already; what follows is of the others.")
    usual = estimate(options.setting, options.counting, left, 1)
    say(_line("If they are of usual length", usual, price))
    if has_tools(options.setting):
        longest = estimate(options.setting, options.counting, left, 1, TURNS)
        say(_line(f"If each takes all {TURNS} calls", longest, price))
    say(
        f"Pictures are taken for {PICTURE_TOKENS} tokens each, replies for {REPLY_TOKENS}: a model "
        "that reasons may write thousands, which cost as replies do. Nothing was asked."
    )


def _done(suite: Suite, options: ModelRunOptions, out: Path) -> set[tuple[str, int]]:
    """Episodes that the folder holds, by task and run."""
    path = out / RECORDS
    order = plan_of(suite, options, out, None).order(options.model, pointer_name(options))
    records = read_records(path, whole=False) if path.exists() else []
    mine = [it for it in records if (it.agent, it.setting) == (order.agent, order.setting)]
    return {(it.task, it.run) for it in mine if it.end != "fault"}


def _line(when: str, found: Estimate, price: Price | None) -> str:
    cost = ""
    if price is not None:
        dollars = found.tokens_in * price.tokens_in + found.tokens_out * price.tokens_out
        cost = f", {dollars / 1e6:,.2f} US dollars"
    asked = f"{found.replies:,} replies, {found.pictures:,} pictures sent"
    tokens = f"{found.tokens_in / 1e6:,.1f} million tokens in and {found.tokens_out / 1e6:,.2f} out"
    return f"{when}: {asked}, about {tokens}{cost}."
