"""Uncovers what lies beneath or behind named things; answers on evidence or not at all."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass

from probe.agents.clearing import Search, with_ids
from probe.agents.moves import Plan, answer, none_of_them, option_by_option
from probe.agents.phrases import Reason, Say
from probe.agents.reading import Box, Graph, Seen, same
from probe.agents.text_features import is_none
from probe.agents.type_plan import ScriptedQuestion
from probe.episodes.turns import Question

_MARGIN_PX = 40
"""What lay beneath a cover may have been dragged so far when that was lifted."""


@dataclass(frozen=True)
class FoundAnswer:
    """A letter, and the occasion to say how it came, with what fills the phrase's slots."""

    letter: str
    occasion: str
    slots: Mapping[str, str]

    def told(self, question: Question, say: Say) -> str:
        """How it came, and which option that makes right; a guess alone is no reason."""
        why = say(self.occasion, {"letter": self.letter, **self.slots})
        if self.occasion == "guess":
            return why
        return f"{why} {option_by_option(question, self.letter, say)}".strip()


def answer_naming(
    question: Question, name: str, occasion: str, slots: Mapping[str, str]
) -> FoundAnswer | None:
    """The letter of the option with a name, else of "None of the above"; None if there is none.

    Args:
        question: Has the options.
        name: What it is.
        occasion: To say so; followed by "none" where no option has the name.
        slots: Fill its phrase.
    """
    for letter, text in question.options:
        if same(name, text):
            return FoundAnswer(letter, occasion, slots)
    none = none_of_them(question)
    return FoundAnswer(none, f"{occasion} none", slots) if none else None


def conclude(asked: ScriptedQuestion, found: FoundAnswer | None, search: Search) -> Plan[None]:
    """Answer; without evidence by chance if bold, else not at all."""
    if found is None and asked.bold:
        options = asked.question.options
        found = FoundAnswer(options[int(search.rng.integers(len(options)))][0], "guess", {})
    if found is not None:
        words = search.after_remarks(found.told(asked.question, search.say))
        yield from answer(found.letter, words=words)


def uncover(asked: ScriptedQuestion, names: Sequence[str], why: Reason) -> Plan[None]:
    """Clear away all that is named, then what lies there still, and name what comes to light.

    Args:
        asked: The question.
        names: What is to be cleared away.
        why: The reason.
    """
    question = asked.question
    search = Search.of(asked)
    yield from search.begin(options_told(question, search.say))
    known = {seen.name for seen in search.graph.named}
    place = around(seen.box for name in names for seen in search.graph.called(name))
    found: FoundAnswer | None = None
    while place is not None:
        left = [seen for name in names for seen in search.graph.called(name)]
        search.remark_moved()
        remark_left(search, left)
        remark_new(search, known, question)
        fresh = [seen for seen in left if search.may_clear(seen)]
        # Pushed, a cover takes along what is beneath: that is where it went.
        place = around([place, *(seen.box for seen in left)]) or place
        if not fresh or len(names) == 1:
            found = uncovered(question, search.graph, known, [place])
        if found is not None:
            break
        if fresh:
            # What lies on top of the others goes first: it would drag them along.
            highest = min(fresh, key=lambda seen: len(search.graph.over(seen)))
            yield from search.clear(highest, why)
        elif not (yield from clear_around(search, place, known)):
            break
    yield from conclude(asked, found, search)


def around(boxes: Iterable[Box]) -> Box | None:
    """The box around all of some; None around none."""
    some = list(boxes)
    if not some:
        return None
    left, top, right, bottom = zip(*some, strict=True)
    return min(left), min(top), max(right), max(bottom)


def remark_left(search: Search, left: Sequence[Seen]) -> None:
    """Say which of the things that are to go show still."""
    if each := with_ids(left):
        search.remark(search.say("to move", {"each": each}))
    elif not left:
        search.remark(search.say("nothing to move", {}))


def remark_new(search: Search, known: Collection[str | None], question: Question) -> None:
    """Say what shows that can be named and didn't show at first, once anything was moved.

    And which option each is, in the words that went before its letter in options_told().
    """
    new = [seen for seen in search.graph.named if seen.name not in known]
    if search.spent and (each := with_ids(new)):
        search.remark(search.say("new", {"each": each}))
        told = dict.fromkeys(_as_option(question, seen) for seen in new if seen.object_id)
        search.remark(search.say("which options", {"each": "; ".join(told)}))
    elif search.spent and not new:
        search.remark(search.say("nothing new", {}))


def newcomers(graph: Graph, known: Collection[str | None], places: Sequence[Box]) -> list[Seen]:
    """What shows in some places and can be named, but wasn't known."""
    return [seen for seen in _here(graph, places) if seen.name and seen.name not in known]


def is_offered(question: Question, seen: Seen) -> bool:
    """Whether what is seen is one of a question's options."""
    return bool(_letters_of(question, seen))


def options_told(question: Question, say: Say) -> str:
    """What each option is, its letter after it: who comes across it again finds its letter so."""
    named = [(letter, text) for letter, text in question.options if not is_none(text)]
    return say("options", {"each": "; ".join(f"{text} is {letter}" for letter, text in named)})


def _as_option(question: Question, seen: Seen) -> str:
    letters = _letters_of(question, seen)
    return f"{seen.name} is {letters[0] if letters else 'no option'}"


def _letters_of(question: Question, seen: Seen) -> list[str]:
    return [letter for letter, text in question.options if same(seen.name or "", text)]


def uncovered(
    question: Question, graph: Graph, known: Collection[str | None], places: Sequence[Box]
) -> FoundAnswer | None:
    """Letter of what came to light in some places; None as long as that isn't clear."""
    new = [seen.name or "" for seen in newcomers(graph, known, places)]
    letters = {letter: n for letter, text in question.options for n in new if same(n, text)}
    if len(letters) == 1:
        ((letter, name),) = letters.items()
        return FoundAnswer(letter, "came out", {"thing": name})
    half_hidden = any(seen.name is None for seen in _here(graph, places))
    none = none_of_them(question)
    if none is None or not new or letters or half_hidden:
        return None
    return FoundAnswer(none, "came out none", {"thing": new[0]})


def clear_around(search: Search, place: Box, known: Collection[str | None]) -> Plan[bool]:
    """Move away the largest thing in a place that was already known; False if there is none."""
    here = [s for s in search.graph.named if _inside(s.point, place) and s.name in known]
    here = [seen for seen in here if search.may_clear(seen)]
    if not here:
        return False
    yield from search.clear(max(here, key=lambda seen: seen.area), Reason("place"))
    return True


def _here(graph: Graph, places: Sequence[Box]) -> list[Seen]:
    return [seen for seen in graph.objects if any(_inside(seen.point, it) for it in places)]


def _inside(point: tuple[int, int], box: Box) -> bool:
    left, top, right, bottom = box
    across = left - _MARGIN_PX <= point[0] <= right + _MARGIN_PX
    return across and top - _MARGIN_PX <= point[1] <= bottom + _MARGIN_PX
