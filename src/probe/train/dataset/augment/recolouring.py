"""The same episode of Compare with other colours, in all that is said of them."""

from __future__ import annotations

import re

import numpy as np

from probe.agents.phrases import Say
from probe.episodes.record import EpisodeRecord
from probe.perception.colour_words import KNOWN
from probe.tasks.task import Task
from probe.train.dataset.augment.certain import NotCertain
from probe.train.dataset.augment.comparing import compared_again
from probe.train.dataset.augment.retelling import (
    changed,
    check_no_name_is_a_colour,
    check_scripted,
    retold,
)

_COLOUR = re.compile(rf"\b(?:{'|'.join(KNOWN)})\b")


def recoloured(
    task: Task, record: EpisodeRecord, rng: np.random.Generator, say: Say
) -> tuple[Task, EpisodeRecord]:
    """A task and an episode in which each colour has become another one, wherever it is named.

    Where the darker thing is asked for, it is the one whose new colour is clearly darker, and may
    have the other letter.

    Args:
        task: What the episode is about.
        record: What happened.
        rng: Chooses the colours.
        say: Chooses the teacher's words.

    Raises:
        NotCertain: No colour is asked for, a thing has the name of one, none that was tried is
            clearly darker, or the teacher isn't the scripted one, or would do something else.
    """
    check_scripted(record)
    if task.question_type != "compare":
        raise NotCertain(record.task, "its colours don't matter")
    check_no_name_is_a_colour(record)
    if task.form != "darker":
        return retold(task, record, _Colours(rng), say)
    return compared_again(record, lambda: changed(task, record, _Colours(rng)), say)


class _Colours:
    """Changes each colour of a text into another one, always the same."""

    def __init__(self, rng: np.random.Generator) -> None:
        others: list[str] = rng.permutation(KNOWN).tolist()
        self._now = dict(zip(KNOWN, others, strict=True))

    def __call__(self, text: str) -> str:
        return _COLOUR.sub(lambda it: self._now[it[0]], text)
