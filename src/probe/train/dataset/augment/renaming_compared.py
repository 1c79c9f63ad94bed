"""Compare, told of things with other names: the question asks for a colour that one of them has."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import replace

import numpy as np

from probe.agents.phrases import Say
from probe.episodes.record import EpisodeRecord
from probe.perception.colour_words import first_colours
from probe.tasks.task import Task
from probe.train.dataset.augment.certain import NotCertain
from probe.train.dataset.augment.comparing import compared_again
from probe.train.dataset.augment.rephrasing import rephrased
from probe.train.dataset.augment.retelling import SlotListener, changed


def renamed_compared(
    task: Task,
    record: EpisodeRecord,
    draw: Callable[[], Callable[[str], str]],
    known: Mapping[str, str],
    rng: np.random.Generator,
    say: Say,
) -> tuple[Task, EpisodeRecord]:
    """A task and an episode in which all things have other names, and colours decide once more.

    Args:
        task: What the episode is about.
        record: What happened.
        draw: Gives what changes the names in a text.
        known: Descriptions of all names that it may give.
        rng: Chooses which of the marked things is asked for, if a colour is.
        say: Chooses the teacher's words.

    Raises:
        NotCertain: The teacher doesn't compare both colours, no names that were tried make one
            thing right, or it would do something else.
    """
    things = _compared_things(task, record, say)

    def once() -> tuple[Task, EpisodeRecord]:
        others = draw()
        name = others(things[int(rng.integers(2))])
        colour = _main_colour(f"{name} {known[name]}")
        return changed(*_asking_for(task, record, colour), others)

    return compared_again(record, once, say)


def _compared_things(task: Task, record: EpisodeRecord, say: Say) -> tuple[str, str]:
    """Names of what is marked A and B, as the teacher knows them in the end."""
    listener = SlotListener(say, "colour_one")
    rephrased(task, record, listener)
    if not listener.heard:
        raise NotCertain(record.task, "its teacher doesn't compare both colours")
    return listener.heard["one"], listener.heard["two"]


def _main_colour(said: str) -> str:
    """The plain word of the first colour that is said of a thing; empty if none is."""
    first = first_colours(said)
    return first.split(" and ")[0].split()[-1] if first else ""


def _asking_for(task: Task, record: EpisodeRecord, colour: str) -> tuple[Task, EpisodeRecord]:
    """A task and an episode whose question has another colour, if it asks for one."""
    if task.form != "colour":
        return task, record
    old = re.compile(rf"\b{re.escape(task.subject)}\b")
    question = replace(record.question, text=old.sub(colour, record.question.text))
    now = replace(task, subject=colour, question=old.sub(colour, task.question))
    return now, replace(record, question=question)
