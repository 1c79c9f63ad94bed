"""An episode with changed texts, and what the scripted teacher says of these."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from typing import Any, cast

from probe.agents.phrases import Say
from probe.episodes.record import EpisodeRecord, Step
from probe.episodes.turns import Call
from probe.perception.colour_words import colour_words_in
from probe.tasks.task import LETTERS, Task
from probe.train.dataset.augment.certain import NotCertain
from probe.train.dataset.augment.listing import said_of_things
from probe.train.dataset.augment.rephrasing import check_teacher, rephrased


@dataclass
class SlotListener:
    """A Say that remembers what filled the slots of the last occasion that has a certain one.

    Attributes:
        say: Gives the words.
        slot: Which one.
        heard: All slots of that occasion; empty as long as there was none.
    """

    say: Say
    slot: str
    heard: Mapping[str, str] = field(default_factory=dict[str, str])

    def __call__(self, occasion: str, slots: Mapping[str, str]) -> str:
        if self.slot in slots:
            self.heard = slots
        return self.say(occasion, slots)


def check_scripted(record: EpisodeRecord) -> None:
    """See that an episode's texts can be changed.

    Raises:
        NotCertain: The scripted teacher didn't teach, or a call's arguments have no names.
    """
    check_teacher(record)
    if not all(isinstance(step.call.values, dict) for step in record.steps):
        raise NotCertain(record.task, "a call is written in another way")


def texts_of(record: EpisodeRecord) -> str:
    """All that tools said in an episode, a reply after another."""
    return "\n".join(step.text for step in record.steps)


def check_no_name_is_a_colour(record: EpisodeRecord) -> None:
    """See that what has the name of a colour in an episode is a colour. An orange has it, too.

    Raises:
        NotCertain: A list names a thing so.
    """
    if any(name in colour_words_in(name) for name, _ in said_of_things(texts_of(record))):
        raise NotCertain(record.task, "a name is a colour, too")


def changed(
    task: Task, record: EpisodeRecord, change: Callable[[str], str]
) -> tuple[Task, EpisodeRecord]:
    """A task and an episode with changes in question, options, calls and replies.

    The teacher's words are as they were.
    """
    options = tuple((letter, change(text)) for letter, text in record.question.options)
    question = replace(record.question, text=change(record.question.text), options=options)
    now = replace(
        task,
        subject=change(task.subject),
        question=change(task.question),
        options=tuple(replace(it, text=change(it.text)) for it in task.options),
    )
    steps = tuple(_step(step, change) for step in record.steps)
    return now, replace(record, question=question, steps=steps)


def retold(
    task: Task, record: EpisodeRecord, change: Callable[[str], str], say: Say
) -> tuple[Task, EpisodeRecord]:
    """The same with what the teacher says then.

    Raises:
        NotCertain: It would do something else.
    """
    now, told = changed(task, record, change)
    return now, rephrased(now, told, say)


def answered(record: EpisodeRecord, given: str) -> EpisodeRecord:
    """An episode with another letter for its answer."""
    assert record.answer
    *before, last = record.steps
    call = Call.of(last.call.name, {**last.call.values, "choice": given}, last.call.words)
    answer = replace(record.answer, choice=given)
    return replace(record, steps=(*before, replace(last, call=call)), answer=answer)


def with_its_answer(task: Task, record: EpisodeRecord, say: Say) -> tuple[Task, EpisodeRecord]:
    """A task and an episode with the letter that the teacher gives now; its other calls stay.

    Args:
        task: Whose answer the episode gives.
        record: What happened; it was right.
        say: Chooses the teacher's words.

    Raises:
        NotCertain: It was wrong or had no answer, or the teacher would do something else before.
    """
    if record.answer is None or record.answer.choice != task.answer:
        raise NotCertain(record.task, "its answer wasn't right")
    doubts = list[NotCertain]()
    for letter in LETTERS[: len(task.options)]:
        try:
            return replace(task, answer=letter), rephrased(task, answered(record, letter), say)
        except NotCertain as doubt:
            doubts.append(doubt)
    raise doubts[0]


def _step(step: Step, change: Callable[[str], str]) -> Step:
    said = cast("Mapping[str, Any]", step.call.values)
    values = {key: change(it) if isinstance(it, str) else it for key, it in said.items()}
    call = Call.of(step.call.name, values, step.call.words)
    return replace(step, call=call, text=change(step.text))
