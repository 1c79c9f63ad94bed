"""Tells a selection's episodes in further ways, and counts those that can't be told so."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Literal

import numpy as np

from probe.agents.phrases import PhraseBook, plainly
from probe.episodes.record import EpisodeRecord
from probe.scene.seeds import generator
from probe.tasks.task import Task
from probe.train.collect.teacher import speaker
from probe.train.dataset.augment.certain import NotCertain
from probe.train.dataset.augment.listed_ids import SayWithoutFinding, without_finding
from probe.train.dataset.augment.mirrored import mirrored
from probe.train.dataset.augment.recolouring import recoloured
from probe.train.dataset.augment.renaming import Descriptions, descriptions_in, renamed
from probe.train.dataset.augment.renumbering import renumbered
from probe.train.dataset.augment.reordering import reordered
from probe.train.dataset.augment.rephrasing import rephrased
from probe.train.dataset.augment.resizing import resized
from probe.train.dataset.augment.rewording import reworded
from probe.train.dataset.augment.thinning import thinned

AugmentationWay = Literal[
    "mirrored", "wordings", "phrases", "options", "names", "ids", "colours", "sizes", "fewer"
]
"""How an episode may be told again: mirrored left to right, asked in other words, with other
phrases of its teacher, with its options or marks under other letters, with other names of all
things, with other object_ids, with other colours (Compare), with other sizes of the marked things
(Size), or with fewer things on the table."""


_MOST_TIMES = 4


@dataclass(frozen=True)
class Augmentation:
    """Episodes that were told again.

    Attributes:
        episodes: In which way, the task and the episode.
        left_out: How many weren't, by way and reason.
    """

    episodes: tuple[tuple[AugmentationWay, Task, EpisodeRecord], ...] = ()
    left_out: Mapping[AugmentationWay, Mapping[str, int]] = field(
        default_factory=dict["AugmentationWay", "Mapping[str, int]"]
    )


def augmented(
    episodes: Sequence[tuple[Task, EpisodeRecord]],
    ways: Sequence[AugmentationWay],
    seed: int,
    *,
    find: bool = True,
    plain: bool = False,
    balanced: bool = False,
) -> Augmentation:
    """Tell each episode once more in each of some ways, where that is certain.

    Args:
        episodes: In the setting "text-only", with their tasks.
        ways: How.
        seed: Chooses among other wordings, phrases, letters, names and object_ids.
        find: Whether what the teacher looks for by find_object is told; if not, in words of
            said_otherwise().
        plain: Whether the teacher says each thing in one way alone; then there are no other
            phrases.
        balanced: Whether those of rare types are told several times in each way, up to four, each
            time otherwise.
    """
    told = list[tuple[AugmentationWay, Task, EpisodeRecord]]()
    left_out: dict[AugmentationWay, Counter[str]] = {way: Counter() for way in ways}
    times = _times(episodes) if balanced else Counter[str]()
    records = [record for _, record in episodes] if "names" in ways else []
    teller = _Teller(seed, find, plain, descriptions_in(records))
    for way in left_out:
        for task, record in episodes:
            often = 1 if way == "mirrored" else max(1, times[task.question_type])
            try:
                again = teller.several(way, task, record, often)
            except NotCertain as doubt:
                left_out[way][doubt.reason] += 1
            else:
                told.extend((way, *each) for each in again)
    return Augmentation(tuple(told), {way: dict(some) for way, some in left_out.items()})


def _times(episodes: Sequence[tuple[Task, EpisodeRecord]]) -> Counter[str]:
    """How often those of each type are told, so that rare types become less rare."""
    counts = Counter(task.question_type for task, _ in episodes)
    most = max(counts.values(), default=0)
    return Counter({kind: min(_MOST_TIMES, most // count) for kind, count in counts.items()})


@dataclass(frozen=True)
class _Teller:
    """Tells episodes again.

    Attributes:
        seed, find, plain: As in augmented().
        known: Names that things may have.
    """

    seed: int
    find: bool
    plain: bool
    known: Descriptions

    def several(
        self, way: AugmentationWay, task: Task, record: EpisodeRecord, often: int
    ) -> list[tuple[Task, EpisodeRecord]]:
        """An episode told so often, each time otherwise; what comes out the same is left out.

        Raises:
            NotCertain: It can't be told so even once.
        """
        told, doubts = list[tuple[Task, EpisodeRecord]](), list[NotCertain]()
        for time in range(often):
            try:
                again = self._once(way, task, record, time)
            except NotCertain as doubt:
                doubts.append(doubt)
                continue
            if again not in told:
                told.append(again)
        if not told:
            raise doubts[0]
        return told

    def _once(
        self, way: AugmentationWay, task: Task, record: EpisodeRecord, time: int
    ) -> tuple[Task, EpisodeRecord]:
        def rng(name: str) -> np.random.Generator:
            # The first time is as without balance.
            return generator(self.seed, name, task.id, record.run, *([time] if time else []))

        if way == "mirrored":
            return task, mirrored(task, self._shown(record))
        if way == "wordings":
            return task, reworded(task, self._shown(record), rng("wording"))
        task, again = self._said(way, task, record, rng)
        return task, self._shown(again)

    def _shown(self, record: EpisodeRecord) -> EpisodeRecord:
        return record if self.find else without_finding(record)

    def _said(
        self,
        way: AugmentationWay,
        task: Task,
        record: EpisodeRecord,
        rng: Callable[[str], np.random.Generator],
    ) -> tuple[Task, EpisodeRecord]:
        """An episode whose teacher is asked again what it would say."""
        drawn = "phrases" if way == "phrases" else f"{way} phrases"
        drawn_anew = speaker(task, record.run) if way == "options" else PhraseBook(rng(drawn))
        usual = plainly if self.plain else drawn_anew
        say = usual if self.find else SayWithoutFinding(usual)
        match way:
            case "options":
                return reordered(task, record, rng("options"), say)
            case "names":
                return renamed(task, record, rng("names"), say, self.known)
            case "ids":
                return renumbered(task, record, rng("ids"), say)
            case "colours":
                return recoloured(task, record, rng("colours"), say)
            case "sizes":
                return resized(task, record, rng("sizes"), say)
            case "fewer":
                return thinned(task, record, rng("fewer"), say)
            case _:
                again = rephrased(task, record, say)
                if again == record:
                    raise NotCertain(record.task, "its teacher's phrases came out the same")
                return task, again
