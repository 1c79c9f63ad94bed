"""A teacher's episodes, task by task, and which of them can be learnt from at all. Pure."""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from probe.episodes.record import EpisodeRecord
from probe.tasks.suite_file import digest_of
from probe.tasks.task import Task
from probe.train.choose.efficiency import waste


@dataclass(frozen=True)
class EpisodeCandidate:
    """An episode.

    Attributes:
        task: What it was about.
        record: What happened.
        correct: Whether it was right; None for our fault.
    """

    task: Task
    record: EpisodeRecord
    correct: bool | None

    @property
    def direct(self) -> bool:
        """Whether it had no tools."""
        return self.record.setting.split(",")[0] == "direct"


Ways = Sequence[EpisodeCandidate]
"""Of one task all episodes to learn from: at most one is taken, the first that fits."""


def usable_by_task(
    candidates: Sequence[EpisodeCandidate], most: Mapping[str, int], dropped: Counter[str]
) -> list[Ways]:
    """Those to learn from, of each task that has some.

    Args:
        candidates: Episodes.
        most: Manipulations that are let pass, by type.
        dropped: Those that aren't to be learnt from are added to it, by reason.
    """
    by_task: defaultdict[str, list[EpisodeCandidate]] = defaultdict(list)
    for it in candidates:
        by_task[digest_of(it.task)].append(it)
    found = [_usable(tried, most, dropped) for tried in by_task.values()]
    return [ways for ways in found if ways]


def _usable(
    tried: Sequence[EpisodeCandidate], most: Mapping[str, int], dropped: Counter[str]
) -> list[EpisodeCandidate]:
    """Those to learn from: without tools if it was right like that each time, then the shortest."""
    without = [it for it in tried if it.direct]
    lucky = not all(it.correct for it in without)
    usable = list[EpisodeCandidate]()
    for it in tried:
        reason = None
        if not it.correct:
            reason = "missing" if it.correct is None else "wrong or unanswered"
        elif it.direct and lucky:
            reason = "right without tools, but not each time"
        else:
            reason = waste(it.record, most.get(it.task.question_type, 0))
        if reason is None:
            usable.append(it)
        else:
            dropped[reason] += 1
    return sorted(usable, key=_length)


def _length(it: EpisodeCandidate) -> tuple[bool, int, int, int]:
    return not it.direct, it.record.manipulations, len(it.record.steps), it.record.run
