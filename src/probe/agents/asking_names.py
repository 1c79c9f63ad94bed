"""Finds out what is which where lists tell kinds of things alone, by asking for things by name.

It asks only for names of whose kind something new shows: an episode has few calls.
"""

from __future__ import annotations

import json
import re
from collections.abc import Sequence
from dataclasses import dataclass, field

from probe.agents.moves import Plan
from probe.agents.reading import Graph, read_exact, read_graph
from probe.episodes.turns import Call, Question
from probe.perception.general import kinds, kinds_in, kinds_told

Names = Sequence[str]

_RENAMED = re.compile(r"\((object_\d+) now\)|\b[Ii]t is (object_\d+) now\b")
_ENTRY = re.compile(r'(- number: \d+\n  object_id: (object_\d+)\n)  name: "(.*)"\n')
_LIST = "perceive_scene"
_WORDS = re.compile(r"[^a-z'-]+")


@dataclass
class KnownNames:
    """What is known of the things that have been listed, by their object_ids.

    Attributes:
        names: Those that may have to be told apart.
        called: By which of them things go.
        listed: All object_ids of earlier lists.
        moved: Those that a manipulation's reply gave to things that were there before.
    """

    names: Names
    called: dict[str, str] = field(default_factory=dict[str, str])
    listed: set[str] = field(default_factory=set[str])
    moved: set[str] = field(default_factory=set[str])

    def heard(self, text: str) -> None:
        """Note which new object_ids a reply gives to things that have moved."""
        self.moved |= {id for pair in _RENAMED.findall(text) for id in pair if id}

    def told(self, text: str) -> Plan[str]:
        """A list with the names of what it shows, after asking for those that may be new."""
        new = [seen for seen in read_graph(text).named if seen.object_id not in self.listed]
        kinds = {seen.name for seen in new}
        for name in self.names:
            if kinds_in(name) & kinds:
                found = yield Call.of("find_object", {"description": name})
                self.called |= dict.fromkeys(read_exact(found), name)
        self.listed |= {seen.object_id for seen in new if seen.object_id}
        return _ENTRY.sub(self._named, text)

    def _named(self, entry: re.Match[str]) -> str:
        """An entry as it is called; by its kind and object_id if it goes by none of the names.

        Such a thing that has moved isn't named, lest it be taken for something that came to light.
        """
        head, id, kind = entry.groups()
        if id in self.called:
            return f"{head}  name: {json.dumps(self.called[id])}\n"
        return head if id in self.moved else f"{head}  name: {json.dumps(f'{kind} {id}')}\n"


def names_in(question: Question, subject: str) -> Names:
    """The names of things in a question, its subject and its options, each once.

    Of what only the question's text names ("the one that was over the red lighter"), the category.
    """
    texts = [*subject.split(", "), *(text for _, text in question.options)]
    told = f" {_WORDS.sub(' ', question.text.lower())} "
    found = [it for it in kinds() if f" {it} " in told]
    longest = [it for it in found if not any(it in other != it for other in (*found, *texts))]
    return [text for text in dict.fromkeys([*longest, *texts]) if kinds_in(text)]


def by_name(plan: Plan[None], names: Names) -> Plan[None]:
    """The same calls; where a list tells kinds alone, those that ask for names come after it."""
    known = KnownNames(names)
    call = next(plan, None)
    while call is not None:
        text = yield call
        known.heard(text)
        if call.name == _LIST and tells_kinds(read_graph(text)):
            text = yield from known.told(text)
        try:
            call = plan.send(text)
        except StopIteration:
            return


def tells_kinds(graph: Graph) -> bool:
    """Whether a list tells kinds alone."""
    return bool(graph.named) and {seen.name for seen in graph.named} <= kinds_told()
