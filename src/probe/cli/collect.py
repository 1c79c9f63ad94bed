"""`probe collect`: let a teacher work on training tasks until enough of them are answered."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

import tyro

from probe.cli.engines import EngineChoice
from probe.cli.model_run import price_of
from probe.cli.numbers import check_numbers
from probe.cli.option_conflicts import refuse_stray
from probe.cli.pool_notice import tell_other_pool
from probe.cli.screen import bar, say
from probe.cli.shards import parse_shard
from probe.cli.teachers import hands_of
from probe.cli.teaching import TeachingSetup
from probe.errors import BadData, Unfinished
from probe.tasks.task import QuestionType
from probe.train.collect.aim import PAPER_COUNTS, Aim, Mode, in_proportion
from probe.train.collect.batches import CollectedBatches
from probe.train.collect.collecting import TeacherWorkers
from probe.train.collect.collecting import collect as collected
from probe.train.collect.settings import claim
from probe.train.collect.training import FIRST_EPISODE

_PAPER = dict(PAPER_COUNTS)


@dataclass(frozen=True)
class CollectionSize:
    """How much is collected, and in which settings.

    Attributes:
        settings: First without tools, then with tools what that didn't answer ("both"), or one
            alone; text-only for a model that sees no pictures.
        always_tools: With tools all tasks, even if the first picture was enough.
        direct_runs: Episodes of each task without tools; all must be right to count as known.
        most_episodes: Stop after this many episodes.
        most_cost: A budget in US dollars. No more tasks are made once another would exceed it, by
            the mean cost so far; needs prices.
        shard: "0/2" and "1/2" on two machines share the work, into a folder each.
        batch: Tasks that are made and played at a time, at most.
        first: Number of the first episode; training starts at 2,000,000.
    """

    settings: Annotated[Mode, tyro.conf.arg(aliases=["--arms"])] = "both"
    always_tools: bool = False
    direct_runs: int = 1
    most_episodes: int | None = None
    most_cost: float | None = None
    shard: str = "0/1"
    batch: int = 48
    first: int = FIRST_EPISODE

    def aim(self, counts: Mapping[QuestionType, int]) -> Aim:
        """What is to be collected.

        Raises:
            BadData: Nothing is asked for, or no training episodes are.
        """
        if self.first < FIRST_EPISODE:
            reason = f"{self.first} isn't for training"
            raise BadData("--first", reason, f"Say {FIRST_EPISODE} or more")
        check_numbers(
            {
                "--batch": self.batch,
                "--direct-runs": self.direct_runs,
                "--first": self.first,
                "--most-episodes": self.most_episodes,
                "--most-cost": self.most_cost,
                **{f"--counts.{question_type}": count for question_type, count in counts.items()},
            }
        )
        aim = Aim(
            counts=counts,
            first=self.first,
            shard=parse_shard(self.shard),
            mode=self.settings,
            always=self.always_tools,
            direct_runs=self.direct_runs,
            batch=self.batch,
            most_episodes=self.most_episodes,
            most_cost=self.most_cost,
        )
        if not aim.total:
            raise BadData("--counts", "asks for nothing", 'Say "--counts.find 20"')
        return aim


_SCRIPTED, _USUAL = TeachingSetup(), CollectionSize()


def collect(
    out: Path = Path("outputs/collected"),
    counts: dict[QuestionType, int] = _PAPER,
    total: int | None = None,
    site: Annotated[TeachingSetup, tyro.conf.arg(name="")] = _SCRIPTED,
    extent: Annotated[CollectionSize, tyro.conf.arg(name="")] = _USUAL,
    where: Annotated[EngineChoice, tyro.conf.arg(name="")] = EngineChoice(),  # noqa: B008
) -> None:
    """Collect a teacher's episodes on fresh training tasks; continues where an earlier run stopped.

    Args:
        out: Folder for tasks and records.
        counts: Tasks of each type to be answered rightly; by default the paper's.
        total: This many in all instead, in the proportions of the counts.
        site: Who teaches, with what.
        extent: How much, and in which settings.
        where: On which machines.
    """
    check_numbers({"--total": total, "--workers": site.workers})
    aim = extent.aim(counts if total is None else in_proportion(counts, total))
    _check_teacher(site, extent.most_cost)
    _check_setting(aim.mode, site)
    if extent.most_cost is not None and site.model is not None:
        _check_price(site.prices, site.model)
    claim(out, site.settings(extent.shard, extent.first))
    tell_other_pool(site.training(), "train", "Records and data sets of them will say so.")
    say(f"Episodes go to {out}; Ctrl-C stops, the same command goes on.")
    so_far = _watched(out, aim, hands_of(site, out, where))
    _tell(out, aim, so_far)


def _check_teacher(site: TeachingSetup, most_cost: float | None) -> None:
    if site.model is None:
        given = {
            "--endpoint": site.endpoint, "--prices": site.prices, "--most-cost": most_cost,
        }  # fmt: skip
        refuse_stray("collect", "without --model", given)


def _check_setting(mode: Mode, site: TeachingSetup) -> None:
    if mode == "text-only" and site.model is None:
        remedy = "Collect with --settings agentic, then say `probe dataset --setting text-only`"
        raise BadData("--settings text-only", "is for models (--model)", remedy)
    if mode != "text-only" and site.graphs is not None:
        reason = "does nothing without --settings text-only"
        raise BadData("--graphs", reason, "Say --settings text-only, or leave it out")


def _check_price(prices: Path | None, model: str) -> None:
    if price_of(prices, model) is None:
        remedy = f"Add --prices FILE with a price of {model}"
        raise BadData("--most-cost", "nobody knows what tokens cost", remedy)


def _watched(out: Path, aim: Aim, hands: TeacherWorkers) -> CollectedBatches:
    """Collect, with a bar of the successes that are wanted."""
    so_far = CollectedBatches()
    with bar() as progress:
        line = progress.add_task("Collecting", total=aim.total)
        for step in collected(out, aim, hands):
            so_far = step.so_far
            progress.update(line, completed=aim.reached(so_far), description=step.doing)
    return so_far


def _tell(out: Path, aim: Aim, so_far: CollectedBatches) -> None:
    reached = aim.reached(so_far)
    for question_type in sorted(aim.counts):
        tried, right = so_far.tasks[question_type], so_far.successes[question_type]
        share = f" ({right / tried:.0%})" if tried else ""
        say(
            f"{question_type}: {right} of {aim.wanted(question_type)} wanted; "
            f"{tried} tasks tried{share}"
        )
    for setting, played in sorted(so_far.played.items()):
        say(f"{setting}: {so_far.right[setting]} of {played} episodes were right")
    cost = f"{so_far.cost:,.2f} US dollars"
    if so_far.unpriced:
        cost += f", without {so_far.unpriced} episodes that have no price"
    say(f"{so_far.episodes} episodes, {so_far.missing} missing by our fault; {cost}.")
    say(f"Tasks and records are in {out}; `probe select {out}` chooses among them.")
    if reached < aim.total:
        remedy = f"The budget of {aim.spent(so_far)} is spent: say more, and run it again."
        raise Unfinished(aim.total - reached, aim.total, "successes", remedy)
