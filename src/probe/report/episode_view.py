"""One episode as a page shows it: the record, its score and where its pictures lie."""

from __future__ import annotations

from dataclasses import dataclass

from probe.episodes.record import EpisodeRecord
from probe.tasks.grading import Score


@dataclass(frozen=True)
class EpisodeView:
    """One graded episode.

    Attributes:
        kind: Question type.
        record: What happened.
        score: What it was worth.
        truth: Letter of the right option.
        pictures: Paths relative to the page: the table at the start and after each step.
    """

    kind: str
    record: EpisodeRecord
    score: Score
    truth: str
    pictures: tuple[str, ...]
