"""What came of an episode with a model, for the harness's own log."""

from __future__ import annotations

from inspect_ai.util import LimitExceededError

from probe.bench.model_conversation import ModelConversation
from probe.episodes.files import record_of
from probe.episodes.record import EpisodeRecord
from probe.runs.worker_messages import EpisodeFinished
from probe.tasks.grading import Score


class FinishedEpisode:
    """An episode that is over.

    Args:
        left: Its record and worth.
        conversation: The conversation; None if it was played before.
        limit: Of the harness, set by the user, that ended it.
    """

    def __init__(
        self,
        left: EpisodeFinished,
        conversation: ModelConversation | None,
        limit: LimitExceededError | None = None,
    ) -> None:
        self.record: EpisodeRecord = record_of(left.line)
        self.score: Score | None = left.score
        self.conversation = conversation
        self.limit = limit
