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
from probe.train.dataset.augment.listing import said_of_things
from probe.train.dataset.augment.retelling import SlotListener, texts_of, with_its_answer

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
            if _is_clear(task.form, listener.heard, told):
                return told
    raise NotCertain(record.task, "no other colours decide clearly")


def _is_clear(form: str, compared: Mapping[str, str], told: tuple[Task, EpisodeRecord]) -> bool:
    """Whether the teacher has compared both, and goes by a clear difference if it asks for one."""
    if not compared:
        return False
    task, record = told
    descriptions = dict(said_of_things(texts_of(record)))
    both = [
        f"{compared[which]} {descriptions.get(compared[which], compared[f'colour_{which}'])}"
        for which in ("one", "two")
    ]
    return form != "darker" or _clearly_darker(*both) == task.answer


def _clearly_darker(one: str, two: str) -> str | None:
    """Letter of what is darker by the first colour that is said of it, its shade included."""
    a, b = (colours_in(said)[:1] for said in (one, two))
    if not (a and b) or abs(a[0][0] - b[0][0]) < DARKER:
        return None
    return "A" if a[0][0] < b[0][0] else "B"
