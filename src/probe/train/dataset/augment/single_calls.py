"""Episodes in which each reply made one call, so that replies and steps go together."""

from __future__ import annotations

from probe.episodes.participation import Participation
from probe.episodes.record import EpisodeRecord
from probe.train.dataset.augment.certain import NotCertain
from probe.transcripts.messages import participation_of


def seat_of_single_calls(record: EpisodeRecord) -> Participation:
    """A record's participation, with as many replies as there are steps.

    Raises:
        NotCertain: Its agent made several calls at once, or none.
    """
    seat = participation_of(record)
    if any(reply.calls != 1 for reply in seat.replies) or len(seat.replies) != len(record.steps):
        raise NotCertain(record.task, "its agent made several calls at once, or none")
    return seat
