"""The same episode with other names of things, or other object_ids, in all that is said of them.

A student that meets each name and number in many places learns to read them where they stand.
"""

from __future__ import annotations

import json
import re
from collections.abc import Callable, Collection, Iterable, Mapping
from dataclasses import dataclass, replace
from typing import Any, cast

import numpy as np

from probe.agents.cover_nouns import hider
from probe.agents.phrases import Say
from probe.episodes.record import EpisodeRecord, Step
from probe.episodes.turns import Call
from probe.tasks.english import plural
from probe.tasks.task import NONE_OF_THE_ABOVE, Task
from probe.train.dataset.augment.certain import NotCertain
from probe.train.dataset.augment.rephrasing import rephrased

Descriptions = Mapping[str, str]
"""What lists say of things, by their names."""

_NAMED = re.compile(
    r'(?P<name>name: )(?P<is>"[^\n]*")(?P<then>\n\s*description: )(?P<said>"[^\n]*")'
)
_ID = re.compile(r"\bobject_(\d+)\b")
_MOST_IDS = 3
"""Times as many object_ids to draw from as an episode has."""


def descriptions_in(records: Iterable[EpisodeRecord]) -> Descriptions:
    """All names in the lists of some episodes, each with what was first said of such a thing."""
    found = dict[str, str]()
    for record in records:
        for name, said in _told_in(record):
            found.setdefault(name, said)
    return found


def renamed(
    task: Task, record: EpisodeRecord, rng: np.random.Generator, say: Say, known: Descriptions
) -> tuple[Task, EpisodeRecord]:
    """A task and an episode in which all things have other names.

    What may hide things gets the name of something that may, too: the scripted teacher must make
    the same calls.

    Args:
        task: What the episode is about.
        record: What happened.
        rng: Chooses the names.
        say: Chooses the teacher's words.
        known: Names to choose from.

    Raises:
        NotCertain: The question is about colours, there are too few names, or the teacher would do
            something else.
    """
    if task.question_type == "compare":
        raise NotCertain(record.task, "names tell the colours that it asks for")
    asked = [it.text for it in task.options if not _is_no_name(it.text)]
    named = task.subject.split(", ") if task.subject else []
    names = dict.fromkeys([*(name for name, _ in _told_in(record)), *asked, *named])
    others = _Others.drawn(record.task, list(names), rng, known)
    return _retold(task, record, others, say)


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
        NotCertain: The teacher would do something else.
    """
    texts = "\n".join(step.text for step in record.steps)
    before = sorted({int(number) for number in _ID.findall(texts)})
    drawn = rng.choice(_MOST_IDS * len(before) or 1, len(before), replace=False)
    now = {old: int(new) + 1 for old, new in zip(before, drawn, strict=True)}

    def change(text: str) -> str:
        return _ID.sub(lambda it: f"object_{now.get(int(it[1]), int(it[1]))}", text)

    return _retold(task, record, change, say)


@dataclass(frozen=True)
class _Others:
    """Other names for some; a call changes a text.

    Attributes:
        names: The new name of each, and the plural of each plural.
        descriptions: Of each new name.
        pattern: Finds entries of lists, and names anywhere.
    """

    names: Mapping[str, str]
    descriptions: Descriptions
    pattern: re.Pattern[str]

    @classmethod
    def drawn(
        cls, task: str, names: Collection[str], rng: np.random.Generator, known: Descriptions
    ) -> _Others:
        """Another name for each of some, among those that may hide as much."""
        free = [it for it in sorted(known) if it not in names and plural(it)]
        order: list[str] = rng.permutation(free).tolist()
        now = dict[str, str]()
        for name in names:
            fitting = next((it for it in order if hider(it) == hider(name)), None)
            if fitting is None:
                raise NotCertain(task, "there are too few other names")
            order.remove(fitting)
            now[name] = fitting
        many = {plural(old): plural(new) for old, new in now.items()}
        all_of_them = now | {old: new for old, new in many.items() if old and new}
        longest_first = sorted(all_of_them, key=len, reverse=True)
        words = "|".join(map(re.escape, longest_first))
        pattern = re.compile(rf"{_NAMED.pattern}|(?<![\w-])(?:{words})(?![\w-])")
        return cls(all_of_them, known, pattern)

    def __call__(self, text: str) -> str:
        """A text with the new names."""
        return self.pattern.sub(self._other, text)

    def _other(self, found: re.Match[str]) -> str:
        if not found["is"]:
            return self.names[found[0]]
        name = self.names[json.loads(found["is"])]
        words = (json.dumps(it, ensure_ascii=False) for it in (name, self.descriptions[name]))
        return f"{found['name']}{next(words)}{found['then']}{next(words)}"


def _retold(
    task: Task, record: EpisodeRecord, change: Callable[[str], str], say: Say
) -> tuple[Task, EpisodeRecord]:
    """A task and an episode with changed texts, and what the teacher says of that."""
    asked = record.question
    options = tuple((letter, change(text)) for letter, text in asked.options)
    question = replace(asked, text=change(asked.text), options=options)
    now = replace(
        task,
        subject=change(task.subject),
        question=change(task.question),
        options=tuple(replace(it, text=change(it.text)) for it in task.options),
    )
    steps = tuple(_step(step, change) for step in record.steps)
    return now, rephrased(now, replace(record, question=question, steps=steps), say)


def _step(step: Step, change: Callable[[str], str]) -> Step:
    said = cast("Mapping[str, Any]", step.call.values)
    values = {key: change(it) if isinstance(it, str) else it for key, it in said.items()}
    call = Call.of(step.call.name, values, step.call.words)
    return replace(step, call=call, text=change(step.text))


def _told_in(record: EpisodeRecord) -> Iterable[tuple[str, str]]:
    """Names in lists, with descriptions."""
    for step in record.steps:
        for found in _NAMED.finditer(step.text):
            yield json.loads(found["is"]), json.loads(found["said"])


def _is_no_name(text: str) -> bool:
    return text == NONE_OF_THE_ABOVE or text.isdecimal() or text in ("Object A", "Object B")
