"""Compare, told of other colours: which letter is right then, the teacher finds out."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from contextlib import suppress

from probe.agents.phrases import Say
from probe.episodes.record import EpisodeRecord
from probe.perception.colour_words import colours_in
from probe.tasks.task import Task
from probe.tasks.truth import DARKER
from probe.train.dataset.augment.certain import NotCertain
from probe.train.dataset.augment.retelling import SlotListener, with_its_answer

_TRIES = 40


def compared_again(
    record: EpisodeRecord, draw: Callable[[], tuple[Task, EpisodeRecord]], say: Say
) -> tuple[Task, EpisodeRecord]:
    """The first of some changed episodes in which the colours of both things decide, and clearly.

    Args:
        record: What happened.
        draw: Gives a task and an episode in which things have other colours, and the teacher still
            has its old words and the old letter.
        say: Chooses the teacher's words.

    Returns:
        The task and the episode with the letter that is right now.

    Raises:
        NotCertain: None that was tried is clear, or the teacher would do something else.
    """
    for _ in range(_TRIES):
        task, changed = draw()
        listener = SlotListener(say, "colour_one")
        # Of colours that fit both things, or neither, the teacher can't tell the letter.
        with suppress(NotCertain):
            told = with_its_answer(task, changed, listener)
            if _is_clear(task.form, listener.heard, told[0].answer):
                return told
    raise NotCertain(record.task, "no other colours decide clearly")


def _is_clear(form: str, compared: Mapping[str, str], letter: str) -> bool:
    if not compared:
        return False
    return form != "darker" or _clearly_darker(compared) == letter


def _clearly_darker(compared: Mapping[str, str]) -> str | None:
    """Letter of the thing that is darker by the first colour of its name, its shade included."""
    a, b = (
        colours_in(f"{compared[which]} {compared[f'colour_{which}']}")[0][0]
        for which in ("one", "two")
    )
    if abs(a - b) < DARKER:
        return None
    return "A" if a < b else "B"
