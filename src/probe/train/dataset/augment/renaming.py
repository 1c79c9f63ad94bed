"""The same episode with other names of things, in all that is said of them.

A student that meets each name in many places learns to read it where it stands.
"""

from __future__ import annotations

import json
import re
from collections.abc import Collection, Iterable, Mapping
from dataclasses import dataclass

import numpy as np

from probe.agents.cover_nouns import hider
from probe.agents.phrases import Say
from probe.episodes.record import EpisodeRecord
from probe.generation.likeness import says_in_part
from probe.perception.colour_words import colour_words_in
from probe.tasks.english import plural
from probe.tasks.task import NONE_OF_THE_ABOVE, Task
from probe.train.dataset.augment.certain import NotCertain
from probe.train.dataset.augment.listing import SAID, said_of_things
from probe.train.dataset.augment.mirrored_reply import others_told
from probe.train.dataset.augment.renaming_compared import renamed_compared
from probe.train.dataset.augment.retelling import (
    check_no_name_is_a_colour,
    check_scripted,
    retold,
    texts_of,
)
from probe.train.dataset.augment.rewording import worded

Descriptions = Mapping[str, str]
"""What lists say of things, by their names."""

_PART = "part of something"


def descriptions_in(records: Iterable[EpisodeRecord]) -> Descriptions:
    """All names in the lists of some episodes, each with the least that was said of such a thing.

    More is said of one that lies on its side, say.
    """
    found = dict[str, str]()
    for record in records:
        for name, said in said_of_things(texts_of(record)):
            found[name] = min(found.get(name, said), said, key=len)
    return found


def renamed(
    task: Task, record: EpisodeRecord, rng: np.random.Generator, say: Say, known: Descriptions
) -> tuple[Task, EpisodeRecord]:
    """A task and an episode in which all things have other names.

    What may hide things gets the name of something that may, too: the scripted teacher must make
    the same calls. In Compare the colours of the new names decide, and the other letter may be
    right.

    Args:
        task: What the episode is about.
        record: What happened.
        rng: Chooses the names.
        say: Chooses the teacher's words.
        known: Names to choose from, those of this episode's lists included.

    Raises:
        NotCertain: A name is a colour or stands where it can't be told for sure, there are too few
            others, none that were tried have colours that decide, or the teacher isn't the scripted
            one or would do something else.
    """
    check_scripted(record)
    check_no_name_is_a_colour(record)
    names = _names_of(task, record, known)

    def draw() -> _OtherNames:
        return _OtherNames.drawn(record.task, names, rng, known)

    others = draw()
    named = {*worded(task, record).slots.values()} - {_asked_colour(task)}
    if any(value == others(value) for value in named):
        raise NotCertain(record.task, "its question may have a name that no list has")
    if task.question_type == "compare":
        return renamed_compared(task, record, draw, known, rng, say)
    return retold(task, record, others, say)


@dataclass(frozen=True)
class _OtherNames:
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
    ) -> _OtherNames:
        """Another name for each of some, among those that may hide as much."""
        free = [it for it in sorted(known) if it not in names and plural(it)]
        order: list[str] = rng.permutation(free).tolist()
        now = dict[str, str]()
        for name in names:
            fitting = (it for it in order if hider(it) == hider(name))
            chosen = next((it for it in fitting if not _alike(it, now.values())), None)
            if chosen is None:
                raise NotCertain(task, "there are too few other names")
            now[name] = chosen
        many = {plural(old): plural(new) for old, new in now.items()}
        all_of_them = now | {old: new for old, new in many.items() if old and new}
        pattern = re.compile(rf"{SAID.pattern}|{_whole_names(all_of_them)}")
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


def _alike(name: str, others: Collection[str]) -> bool:
    return any(name == it or says_in_part(name, it) for it in others)


def _names_of(task: Task, record: EpisodeRecord, known: Descriptions) -> list[str]:
    """All names in an episode: in its lists, its options, and known ones in all that is said.

    Raises:
        NotCertain: A reply says of something that it has moved, and no list names that.
    """
    listed = {name for name, _ in said_of_things(texts_of(record))}
    offered = {it.text for it in task.options if not task.marks and _is_name(it.text)}
    subjects = {*filter(None, task.subject.split(", "))} - {_asked_colour(task)}
    texts = [SAID.sub("", step.text) for step in record.steps]
    names = listed | offered | subjects | _spoken("\n".join([task.question, *texts]), known)
    moved = [it for text in texts for it in others_told(text)]
    if any(_PART not in it and not any(name in it for name in names) for it in moved):
        raise NotCertain(record.task, "a reply names something that no list has")
    return sorted(names)


def _asked_colour(task: Task) -> str | None:
    return task.subject if task.question_type == "compare" and task.form == "colour" else None


def _spoken(text: str, known: Descriptions) -> set[str]:
    """Known names in a text; a word for a colour is none."""
    likely = [it for it in known if it in text and it not in colour_words_in(it)]
    if not likely:
        return set()
    return {*re.findall(_whole_names(likely), text)}


def _whole_names(names: Iterable[str]) -> str:
    """A pattern of names that stand for themselves, not within another of them."""
    words = "|".join(map(re.escape, sorted(names, key=len, reverse=True)))
    return rf"(?<![\w-])(?:{words})(?![\w-])"


def _is_name(option: str) -> bool:
    """Whether an option isn't "None of the above" or a number."""
    return option != NONE_OF_THE_ABOVE and not option.isdecimal()
