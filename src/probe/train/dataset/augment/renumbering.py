"""The same episode with other object_ids, in no order, so that they are read and not counted."""

from __future__ import annotations

import re

import numpy as np

from probe.agents.phrases import Say
from probe.episodes.record import EpisodeRecord
from probe.tasks.task import Task
from probe.train.dataset.augment.retelling import check_scripted, retold, texts_of

_ID = re.compile(r"\bobject_(\d+)\b")
_MOST_IDS = 3
"""Times as many object_ids to draw from as an episode has."""


def renumbered(
    task: Task, record: EpisodeRecord, rng: np.random.Generator, say: Say
) -> tuple[Task, EpisodeRecord]:
    """An episode in which all things have other object_ids.

    Args:
        task: What the episode is about.
        record: What happened.
        rng: Chooses the object_ids.
        say: Chooses the teacher's words.

    Raises:
        NotCertain: The teacher isn't the scripted one, or would do something else.
    """
    check_scripted(record)
    before = sorted({int(number) for number in _ID.findall(texts_of(record))})
    drawn = rng.choice(_MOST_IDS * len(before) or 1, len(before), replace=False)
    now = {old: int(new) + 1 for old, new in zip(before, drawn, strict=True)}

    def change(text: str) -> str:
        return _ID.sub(lambda it: f"object_{now.get(int(it[1]), int(it[1]))}", text)

    return retold(task, record, change, say)
