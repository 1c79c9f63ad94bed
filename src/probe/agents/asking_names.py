"""Finds out what is which where lists tell kinds of things alone, by asking for things by name.

It asks only for names of whose kind something new shows: an episode has few calls.
"""

from __future__ import annotations

import json
import re
from collections.abc import Sequence
from dataclasses import dataclass, field

from probe.agents.moves import Plan
from probe.agents.reading import read_exact, read_new_handles
from probe.agents.text_features import is_none
from probe.episodes.turns import Call, Question
from probe.perception.general import UNKNOWN, kinds, kinds_in, kinds_told
from probe.perception.tokens import is_colour, tokens

Names = Sequence[str]

_ENTRY = re.compile(r'(- number: \d+\n  object_id: (object_\d+)\n)  name: "(.*)"\n')
_LIST = "perceive_scene"
_OTHERS = re.compile(r"[^a-z'-]+")
_NAME = re.compile(r"^[A-Za-z' -]*[a-z]{3}[A-Za-z' -]*$")
_SHADES = ("dark", "light", "mainly")


@dataclass
class KnownNames:
    """What is known of the things that have been listed, by their object_ids.

    Attributes:
        names: Names that have to be told apart; longer ones decide where several fit.
        found: The name that a thing was found by.
        labels: What stands for a name of the others: their kind and first object_id.
        kinds: The kind that lists tell of it.
        moved: Object_ids that a manipulation's reply gave to things that were there before.
    """

    names: Names
    found: dict[str, str] = field(default_factory=dict[str, str])
    labels: dict[str, str] = field(default_factory=dict[str, str])
    kinds: dict[str, str] = field(default_factory=dict[str, str])
    moved: set[str] = field(default_factory=set[str])

    def told(self, text: str) -> Plan[str]:
        """A list with the names of what it shows, after asking for those that may be new.

        A list that tells more than kinds is left as it is.
        """
        listed = {id: kind for _, id, kind in _ENTRY.findall(text)}
        if not kinds_told().issuperset(listed.values()):
            return text
        new = {id: kind for id, kind in listed.items() if id not in self.kinds}
        for name in self.names:
            possible = kinds_in(name)
            if new and (not possible or possible & {*new.values()} or UNKNOWN in new.values()):
                reply = yield Call.of("find_object", {"description": name})
                self.found |= dict.fromkeys(read_exact(reply), name)
        self.kinds |= new
        gone = [id for id in self.labels if id not in listed]
        for id in new:
            if id not in self.found:
                self._label(id, gone)
        return _ENTRY.sub(self._named, text)

    def _label(self, id: str, gone: list[str]) -> None:
        """What stands for a new thing's name; of what moved the label of one that is gone.

        Of several of its kind, which is which can't be told; whatever it is, it hasn't come to
        light. Where none is gone, it stays without.
        """
        kind = self.kinds[id]
        if id not in self.moved:
            self.labels[id] = f"{kind} {id}"
        elif same := [earlier for earlier in gone if self.kinds[earlier] == kind]:
            gone.remove(same[0])
            self.labels[id] = self.labels[same[0]]

    def _named(self, entry: re.Match[str]) -> str:
        """An entry as it is called; without a name if it moved and nobody knows what it was."""
        head, id, _ = entry.groups()
        name = self.found.get(id) or self.labels.get(id)
        return f"{head}  name: {json.dumps(name)}\n" if name else head


def names_in(question: Question, subject: str, fixed: Sequence[str]) -> Names:
    """The names of things in a question, its subject and its options; those of few words first.

    Of a thing that only the question's text names ("the one that was over the red lighter") the
    category is found.

    Args:
        question: As it is asked.
        subject: The words of it that name a thing; a colour names none.
        fixed: Ways to ask this type of question: a category in one of them names no thing.
    """
    texts = [*subject.split(", "), *(text for _, text in question.options if not is_none(text))]
    names = [text for text in texts if _NAME.search(text) and not _only_colours(text)]
    said, usual = _as_words(question.text), _as_words(" ".join(fixed))
    found = [it for it in kinds() if f" {it} " in said and f" {it} " not in usual]
    alone = [it for it in found if not any(it in other != it for other in (*found, *names))]
    return sorted(dict.fromkeys([*alone, *names]), key=lambda name: len(name.split()))


def _only_colours(text: str) -> bool:
    return all(is_colour(token) or token in _SHADES for token in tokens(text))


def _as_words(text: str) -> str:
    return f" {_OTHERS.sub(' ', text.lower())} "


def by_name(plan: Plan[None], names: Names) -> Plan[None]:
    """The same calls; where a list tells kinds alone, those that ask for names come after it."""
    known = KnownNames(names)
    call = next(plan, None)
    while call is not None:
        text = yield call
        known.moved |= read_new_handles(text)
        if call.name == _LIST:
            text = yield from known.told(text)
        try:
            call = plan.send(text)
        except StopIteration:
            return
