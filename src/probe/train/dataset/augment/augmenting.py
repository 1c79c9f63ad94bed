"""Tells a selection's episodes in further ways, and counts those that can't be told so."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Literal

import numpy as np

from probe.agents.phrases import PhraseBook, Say
from probe.episodes.record import EpisodeRecord
from probe.scene.seeds import generator
from probe.tasks.task import Task
from probe.train.dataset.augment.certain import NotCertain
from probe.train.dataset.augment.mirrored import mirrored
from probe.train.dataset.augment.rephrasing import rephrased
from probe.train.dataset.augment.rewording import reworded

AugmentationWay = Literal["mirrored", "wordings", "phrases"]
"""How an episode may be told again: mirrored left to right, asked in other words, or with other
phrases of its teacher."""


def _as_ever(say: Say) -> Say:
    return say


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
    saying: Callable[[Say], Say] = _as_ever,
) -> Augmentation:
    """Tell each episode once more in each of some ways, where that is certain.

    Args:
        episodes: In the setting "text-only", with their tasks.
        ways: How.
        seed: Chooses among other wordings and phrases.
        saying: What the teacher says, given what chooses among its phrases.
    """
    told = list[tuple[AugmentationWay, Task, EpisodeRecord]]()
    left_out: dict[AugmentationWay, Counter[str]] = {way: Counter() for way in ways}
    for way in left_out:
        for task, record in episodes:
            try:
                told.append((way, task, _told(way, task, record, seed, saying)))
            except NotCertain as doubt:
                left_out[way][doubt.reason] += 1
    return Augmentation(tuple(told), {way: dict(some) for way, some in left_out.items()})


def _told(
    way: AugmentationWay,
    task: Task,
    record: EpisodeRecord,
    seed: int,
    saying: Callable[[Say], Say],
) -> EpisodeRecord:
    def rng(name: str) -> np.random.Generator:
        return generator(seed, name, task.id, record.run)

    match way:
        case "mirrored":
            return mirrored(task, record)
        case "wordings":
            return reworded(task, record, rng("wording"))
        case "phrases":
            told = rephrased(task, record, saying(PhraseBook(rng("phrases"))))
            if told == record:
                raise NotCertain(record.task, "its teacher's phrases came out the same")
            return told
