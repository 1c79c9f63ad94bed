"""The same episode of Size in which the two marked things have other sizes."""

from __future__ import annotations

import json
import re
from itertools import islice

import numpy as np

from probe.agents.phrases import Say
from probe.agents.reading import read_graph
from probe.episodes.record import EpisodeRecord
from probe.tasks.task import Task
from probe.train.dataset.augment.certain import NotCertain
from probe.train.dataset.augment.other_boxes import Factors, other_factors, resized_box
from probe.train.dataset.augment.rephrasing import rephrased
from probe.train.dataset.augment.retelling import (
    SlotListener,
    changed,
    check_scripted,
    with_its_answer,
)

_TRIES = 8
_SIZED = re.compile(
    r'(?P<before>name: (?P<name>"[^\n]*")\n\s*description: [^\n]*\n\s*point: [^\n]*\n\s*box: )'
    r"\[(?P<box>\d+, \d+, \d+, \d+)\]"
)


def resized(
    task: Task, record: EpisodeRecord, rng: np.random.Generator, say: Say
) -> tuple[Task, EpisodeRecord]:
    """A task and an episode in which lists tell other boxes of the marked things, which decide.

    Args:
        task: What the episode is about.
        record: What happened.
        rng: Chooses the sizes, and the right letter where sizes that fit allow either.
        say: Chooses the teacher's words.

    Raises:
        NotCertain: Sizes aren't asked for, the teacher didn't say what the marked things are, or
            isn't the scripted one, or would do something else.
    """
    check_scripted(record)
    if task.question_type != "size":
        raise NotCertain(record.task, "its sizes don't matter")
    asked = SlotListener(say, "size_one")
    rephrased(task, record, asked)
    if not asked.heard:
        raise NotCertain(record.task, "its teacher named no two things")
    compared = asked.heard["one"], asked.heard["two"]
    doubts, side_px = list[NotCertain](), record.scale.side_px
    seen = [it for step in record.steps for it in read_graph(step.text).objects]
    marks = [mark.point for mark in task.marks]
    for factors in islice(other_factors(compared, seen, marks, side_px, rng), _TRIES):
        told = changed(task, record, lambda text, by=factors: _with_sizes(text, by, side_px))[1]
        try:
            return with_its_answer(task, told, say)
        except NotCertain as doubt:
            doubts.append(doubt)
    raise doubts[0] if doubts else NotCertain(record.task, "no other sizes fit what shows")


def _with_sizes(text: str, factors: Factors, side_px: int) -> str:
    """A text in which the boxes of some things have other sizes about their middles."""

    def sized(found: re.Match[str]) -> str:
        factor = factors.get(json.loads(found["name"]))
        if factor is None:
            return found[0]
        left, top, right, bottom = map(int, found["box"].split(", "))
        box = resized_box((left, top, right, bottom), factor, side_px)
        return f"{found['before']}{[*box]}"

    return _SIZED.sub(sized, text)
