"""Tells a selection's episodes in further ways, and counts those that can't be told so."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from probe.episodes.record import EpisodeRecord
from probe.tasks.task import Task
from probe.train.dataset.augment.certain import NotCertain
from probe.train.dataset.augment.renaming import descriptions_in
from probe.train.dataset.augment.speech import AS_TAUGHT, Speech
from probe.train.dataset.augment.teller import AugmentationWay, Teller

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
    speech: Speech = AS_TAUGHT,
    *,
    balanced: bool = False,
) -> Augmentation:
    """Tell each episode once more in each of some ways, where that is certain.

    Args:
        episodes: In the setting "text-only", with their tasks.
        ways: How.
        seed: Chooses among other wordings, phrases, letters, names and object_ids.
        speech: How the teacher speaks in the data set. Plainly, it has no other phrases.
        balanced: Whether those of rare types are told several times in each way, up to four, each
            time otherwise: also with other names and sizes, if these are among the ways.
    """
    told = list[tuple[AugmentationWay, Task, EpisodeRecord]]()
    left_out: dict[AugmentationWay, Counter[str]] = {way: Counter() for way in ways}
    times = _times(episodes) if balanced else Counter[str]()
    records = [record for _, record in episodes] if "names" in ways else []
    teller = Teller(seed, speech, ways, descriptions_in(records))
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
