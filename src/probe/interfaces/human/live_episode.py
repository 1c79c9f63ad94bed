"""One question at one table: what has been called, told and shown. Knows no threads, no page."""

from __future__ import annotations

import logging

from PIL import Image

from probe.episodes.episode import Episode
from probe.episodes.record import EpisodeRecord
from probe.episodes.replay import resume
from probe.episodes.turns import Call, Turn
from probe.files import encode
from probe.interfaces.human.call_entries import CallEntry, entry_of
from probe.tasks.task import Task
from probe.types import Array

_log = logging.getLogger(__name__)


class LiveEpisode:
    """A question's episode, with its pictures as PNG and an entry for each call.

    Args:
        place: Of the task in its suite, from 0.
        task: What is asked.
        episode: Fresh.
        earlier: The same run as it was left, to be gone on with; None to begin.

    Raises:
        NotAsBefore: It can't be gone on with.
    """

    def __init__(
        self, place: int, task: Task, episode: Episode, earlier: EpisodeRecord | None
    ) -> None:
        self.place = place
        self.task = task
        self.episode = episode
        self.entries: tuple[CallEntry, ...] = ()
        first = episode.record.question.picture
        assert first is not None, "a person needs pictures"
        self.pictures: tuple[bytes, ...] = (_png(first),)
        for turn in resume(earlier, episode) if earlier else ():
            self._take(turn)

    def step(self, call: Call) -> None:
        """Do a call; a mistake of ours ends the episode as a fault."""
        try:
            turn = self.episode.step(call)
        except Exception as error:  # the record has to say so, too
            _log.exception("A call failed")
            turn = Turn(call, self.episode.fail(error))
        self._take(turn)

    def _take(self, turn: Turn) -> None:
        picture = turn.result.picture
        if picture is not None:
            self.pictures = (*self.pictures, _png(picture))
        entry = entry_of(turn, len(self.pictures) - 1, fresh=picture is not None)
        self.entries = (*self.entries, entry)


def _png(picture: Array) -> bytes:
    return encode(Image.fromarray(picture), "PNG")
