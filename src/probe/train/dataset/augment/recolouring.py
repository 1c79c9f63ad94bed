"""The same episode of Compare with other colours, in all that is said of them."""

from __future__ import annotations

import re

import numpy as np

from probe.agents.phrases import Say
from probe.episodes.record import EpisodeRecord
from probe.perception.colour_words import KNOWN
from probe.tasks.task import Task
from probe.train.dataset.augment.certain import NotCertain
from probe.train.dataset.augment.retelling import check_scripted, retold

_COLOUR = re.compile(rf"\b(?:{'|'.join(KNOWN)})\b")


def recoloured(
    task: Task, record: EpisodeRecord, rng: np.random.Generator, say: Say
) -> tuple[Task, EpisodeRecord]:
    """A task and an episode in which each colour has become another one, wherever it is named.

    Args:
        task: What the episode is about.
        record: What happened.
        rng: Chooses the colours.
        say: Chooses the teacher's words.

    Raises:
        NotCertain: No colour is asked for, or which is darker; or the teacher isn't the scripted
            one, or would do something else.
    """
    check_scripted(record)
    if task.question_type != "compare":
        raise NotCertain(record.task, "its colours don't matter")
    if task.form == "darker":
        raise NotCertain(record.task, "which of other colours is darker may be close")
    others: list[str] = rng.permutation(KNOWN).tolist()
    now = dict(zip(KNOWN, others, strict=True))
    return retold(task, record, lambda text: _COLOUR.sub(lambda it: now[it[0]], text), say)
