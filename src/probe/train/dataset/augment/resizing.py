"""The same episode of Size in which the two marked things have other sizes."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from probe.agents.phrases import Say
from probe.episodes.record import EpisodeRecord
from probe.tasks.task import Task
from probe.train.dataset.augment.certain import NotCertain
from probe.train.dataset.augment.rephrasing import rephrased
from probe.train.dataset.augment.retelling import changed, check_scripted, with_its_answer

_SMALLEST, _LARGEST = 0.05, 0.25
"""Width and height of a box, as shares of the picture's side."""
_CLEARLY = 1.2
"""By how much one diagonal and one area must be larger than the other."""
_TRIES = 8
_SIZED = re.compile(
    r'(?P<before>name: (?P<name>"[^\n]*")\n\s*description: [^\n]*\n\s*point: [^\n]*\n\s*box: )'
    r"\[(?P<box>\d+, \d+, \d+, \d+)\]"
)

Sizes = Mapping[str, tuple[int, int]]
"""Width and height of boxes in pixels, by names."""


def resized(
    task: Task, record: EpisodeRecord, rng: np.random.Generator, say: Say
) -> tuple[Task, EpisodeRecord]:
    """A task and an episode in which lists tell other boxes of the marked things, which decide.

    Args:
        task: What the episode is about.
        record: What happened.
        rng: Chooses the sizes.
        say: Chooses the teacher's words.

    Raises:
        NotCertain: Sizes aren't asked for, the teacher didn't say what the marked things are, or
            isn't the scripted one, or would do something else.
    """
    check_scripted(record)
    if task.question_type != "size":
        raise NotCertain(record.task, "its sizes don't matter")
    asked = _Listener(say)
    rephrased(task, record, asked)
    if len(asked.compared) != 2:
        raise NotCertain(record.task, "its teacher named no two things")
    doubts, side_px = list[NotCertain](), record.scale.side_px
    for _ in range(_TRIES):
        shares = np.exp(rng.uniform(np.log(_SMALLEST), np.log(_LARGEST), (2, 2)))
        drawn = np.rint(shares * side_px).astype(int).tolist()
        sizes = {name: (w, h) for name, (w, h) in zip(asked.compared, drawn, strict=True)}
        told = changed(task, record, lambda text, by=sizes: _with_sizes(text, by, side_px))[1]
        again = _Listener(say)
        try:
            now, told = with_its_answer(task, told, again)
        except NotCertain as doubt:
            doubts.append(doubt)
            continue
        if _differ(again.sizes):
            return now, told
    raise doubts[0] if doubts else NotCertain(record.task, "no other sizes differ clearly")


@dataclass
class _Listener:
    """A Say that remembers what the two marked things are called, and their boxes' sizes."""

    say: Say
    compared: tuple[str, ...] = ()
    sizes: tuple[tuple[int, int], ...] = ()

    def __call__(self, occasion: str, slots: Mapping[str, str]) -> str:
        if "size_one" in slots:
            self.compared = (slots["one"], slots["two"])
            one, two = (json.loads(slots[it]) for it in ("size_one", "size_two"))
            self.sizes = ((one[0], one[1]), (two[0], two[1]))
        return self.say(occasion, slots)


def _with_sizes(text: str, sizes: Sizes, side_px: int) -> str:
    """A text in which the boxes of some things have other sizes about their middles."""

    def sized(found: re.Match[str]) -> str:
        size = sizes.get(json.loads(found["name"]))
        if size is None:
            return found[0]
        left, top, right, bottom = map(int, found["box"].split(", "))
        across = _around(left, right, size[0], side_px)
        down = _around(top, bottom, size[1], side_px)
        return f"{found['before']}{[across[0], down[0], across[1], down[1]]}"

    return _SIZED.sub(sized, text)


def _around(low: int, high: int, length: int, side_px: int) -> tuple[int, int]:
    """First and last pixel of so long a side of a box, inside the picture."""
    first = min(max(round((low + high + 1 - length) / 2), 0), side_px - length)
    return first, first + length - 1


def _differ(sizes: tuple[tuple[int, int], ...]) -> bool:
    """Whether one of two boxes is clearly larger, whichever way one looks at it."""
    if len(sizes) != 2:
        return False
    (w, h), (v, g) = sizes
    diagonals, areas = sorted((w * w + h * h, v * v + g * g)), sorted((w * h, v * g))
    return diagonals[1] > _CLEARLY**2 * diagonals[0] and areas[1] > _CLEARLY * areas[0]
