"""How many episodes are wanted, and what the next batch should be. Arithmetic only."""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass
from itertools import islice
from typing import Literal

from probe.errors import BadData
from probe.generation.build_folder import TaskSlot
from probe.tasks.task import QUESTION_TYPES, QuestionType
from probe.train.collect.batches import CollectedBatches, fresh_places
from probe.transcripts.prompts import Setting
from probe.types import Shard

PAPER_COUNTS: Mapping[QuestionType, int] = {
    "count": 521,
    "find": 800,
    "compare": 785,
    "size": 610,
    "reduce": 231,
    "beneath": 0,
}
"""Successful episodes of the paper's fine-tuning, by type; Beneath is held out."""


def uncollected(types: Collection[QuestionType]) -> tuple[QuestionType, ...]:
    """Those of some types of which no episodes are collected by default."""
    return tuple(it for it in QUESTION_TYPES if it in types and not PAPER_COUNTS.get(it))


def in_proportion(counts: Mapping[QuestionType, int], total: int) -> dict[QuestionType, int]:
    """Counts of the same proportions that add up to a total; the largest remainders get the rest.

    Raises:
        BadData: There is nothing to share.
    """
    whole = sum(counts.values())
    if not whole:
        raise BadData("--counts", "asks for nothing", 'Say "--counts.find 20"')
    shares: dict[QuestionType, float] = {k: n * total / whole for k, n in counts.items()}
    made: dict[QuestionType, int] = {
        question_type: int(share) for question_type, share in shares.items()
    }
    by_rest = sorted(
        shares,
        key=lambda question_type: (made[question_type] - shares[question_type], question_type),
    )
    for question_type in by_rest[: total - sum(made.values())]:
        made[question_type] += 1
    return made


def _shared(needs: Mapping[QuestionType, int], most: int) -> dict[QuestionType, int]:
    """What is needed, within a number: one of each type that lacks some, the rest in proportion.

    If not even that many are allowed, the types with the largest needs get one.
    """
    lacking = {question_type: need for question_type, need in needs.items() if need}
    if sum(lacking.values()) <= most:
        return lacking
    first = sorted(lacking, key=lambda question_type: -lacking[question_type])[:most]
    if len(first) == most:
        return dict.fromkeys(first, 1)
    others = in_proportion({it: lacking[it] - 1 for it in first}, most - len(first))
    return {question_type: 1 + others[question_type] for question_type in first}


Mode = Literal["both", "direct", "agentic", "text-only"]
_MARGIN = 1.1


@dataclass(frozen=True)
class Aim:
    """What is to be collected.

    Attributes:
        counts: Tasks that were answered rightly, by type, all shards together.
        first: Number of the first episode.
        shard: Which part of it.
        mode: Which settings; "both" is direct, then agentic.
        always: With both settings, use tools even where the first picture was enough.
        direct_runs: Episodes of a task without tools.
        batch: Tasks of a batch at most.
        most_episodes: Budget of this shard; None for no end.
        most_cost: Budget of this shard, US dollars; None for no end.
    """

    counts: Mapping[QuestionType, int]
    first: int
    shard: Shard = Shard()
    mode: Mode = "both"
    always: bool = False
    direct_runs: int = 1
    batch: int = 48
    most_episodes: int | None = None
    most_cost: float | None = None

    def wanted(self, question_type: QuestionType) -> int:
        """This shard's part of a count."""
        return len(range(self.shard.number, self.counts.get(question_type, 0), self.shard.count))

    @property
    def total(self) -> int:
        """Of all types."""
        return sum(self.wanted(question_type) for question_type in self.counts)

    @property
    def episodes_a_task(self) -> int:
        """At most."""
        return {"both": self.direct_runs + 1, "direct": self.direct_runs}.get(self.mode, 1)

    @property
    def settings(self) -> tuple[Setting, ...]:
        """In which tasks are played, in this order."""
        return ("direct", "agentic") if self.mode == "both" else (self.mode,)

    def reached(self, so_far: CollectedBatches) -> int:
        """Successes that count; more of a type than wanted don't."""
        return sum(
            min(so_far.successes[question_type], self.wanted(question_type))
            for question_type in self.counts
        )

    def spent(self, so_far: CollectedBatches) -> str | None:
        """Which budget has no room for another task; None if there is room."""
        if self._room(so_far) > 0:
            return None
        few = self.most_episodes is not None and self._by_episodes(so_far) <= 0
        return "episodes" if few else "cost"

    def next_places(
        self, so_far: CollectedBatches, exhausted: Callable[[TaskSlot], bool] = lambda _: False
    ) -> list[TaskSlot]:
        """What to make next: as much as is lacking by the success rates so far, within a batch.

        Args:
            so_far: What there is.
            exhausted: Whether a place has been tried in vain; it is left out.
        """
        needs = {question_type: self._need(question_type, so_far) for question_type in self.counts}
        shares = _shared(needs, min(self.batch, self._room(so_far)))
        places = list[TaskSlot]()
        for question_type in sorted(shares, key=lambda question_type: -shares[question_type]):
            fresh = fresh_places(
                question_type, self.first, self.shard, so_far.last.get(question_type)
            )
            left = (place for place in fresh if not exhausted(place))
            places += islice(left, shares[question_type])
        return places

    def _need(self, question_type: QuestionType, so_far: CollectedBatches) -> int:
        lacking = self.wanted(question_type) - so_far.successes[question_type]
        rate = (so_far.successes[question_type] + 1) / (so_far.tasks[question_type] + 2)
        return math.ceil(_MARGIN * lacking / rate) if lacking > 0 else 0

    def _room(self, so_far: CollectedBatches) -> int:
        """Tasks that the budgets still allow."""
        room = self.batch
        if self.most_episodes is not None:
            room = min(room, self._by_episodes(so_far))
        if self.most_cost is not None:
            room = min(room, self._by_cost(so_far))
        return room

    def _by_episodes(self, so_far: CollectedBatches) -> int:
        assert self.most_episodes is not None
        return (self.most_episodes - so_far.episodes) // self.episodes_a_task

    def _by_cost(self, so_far: CollectedBatches) -> int:
        """By what episodes have cost so far; a first batch is small.

        Episodes whose cost isn't known are taken to cost as much as others; if none is known,
        nothing more may be spent.
        """
        assert self.most_cost is not None
        tasks, priced = sum(so_far.tasks.values()), so_far.episodes - so_far.unpriced
        if not tasks:
            return len(self.counts)
        if not priced:
            return 0
        cost = so_far.cost * so_far.episodes / priced
        left, each = self.most_cost - cost, cost / tasks
        if left <= 0:
            return 0
        return self.batch if each == 0 else int(left / each)
