"""How the scripted agent goes about Size: it uncovers both things and goes by their boxes."""

from __future__ import annotations

import math

from probe.agents.clearing import Search
from probe.agents.marks import guess_mark, marked_at_sight, uncover_both
from probe.agents.moves import Plan, answer
from probe.agents.phrases import Say
from probe.agents.reading import Seen
from probe.agents.type_plan import FirstLookAnswer, FirstLookQuestion, ScriptedQuestion, TypePlan


def _begin(asked: ScriptedQuestion) -> Plan[None]:
    """Uncover both marked things and go by the boxes that they then have."""
    form, say = asked.form, asked.say
    search = Search.of(asked)
    yield from search.begin()
    search.remark(say(f"asked {form}", {}))
    one, other = yield from uncover_both(asked.question, search, bold=asked.bold)
    if one is not None and other is not None:
        letter = _larger(form, one, other)
        words = search.after_remarks(_reason(form, letter, (one, other), say))
        yield from answer(letter, words=words)
    elif asked.bold:
        yield from guess_mark(asked.rng, say)


def _larger(form: str, one: Seen, other: Seen) -> str:
    """Letter of the longer, larger or smaller one, by their boxes."""
    a, b = (_length(seen) if form == "longer" else seen.area for seen in (one, other))
    return _fitting(form, a, b)


def _fitting(form: str, a: float, b: float) -> str:
    """Letter of the one that is asked for, by a measure of each."""
    return "A" if (a > b) != (form == "smaller") else "B"


def _length(seen: Seen) -> float:
    """Its longest side in pixels, as far as a box tells: the diagonal, for what lies askew."""
    left, top, right, bottom = seen.box
    return math.hypot(right - left, bottom - top)


def _reason(form: str, letter: str, both: tuple[Seen, Seen], say: Say) -> str:
    one, two = both
    if one.size == two.size:
        return say("guess", {"letter": letter})
    names = {"one": one.name or "", "two": two.name or ""}
    boxes = {"size_one": str(list(one.size)), "size_two": str(list(two.size))}
    said = [say("size both", names | boxes)]
    # By diagonal or area it may be otherwise; then the boxes alone are told.
    a, b = max(one.size), max(two.size)
    if a != b and letter == _fitting(form, a, b):
        sides = {"long_one": str(a), "long_two": str(b)}
        said.append(say("size sides", sides | _compared(form, a, b)))
    said.append(say(f"size {form}", {"letter": letter}))
    return " ".join(said).strip()


def _compared(form: str, a: int, b: int) -> dict[str, str]:
    """Which of A and B is more and which is less, and what that is called."""
    more, less = "AB" if a > b else "BA"
    greater, lesser = ("longer", "shorter") if form == "longer" else ("larger", "smaller")
    letters = {"letter_more": more, "letter_less": less}
    return letters | {"greater": greater, "lesser": lesser}


def _at_sight(asked: FirstLookQuestion, say: Say) -> FirstLookAnswer | None:
    """Only if nothing lies on either."""
    one, two = marked_at_sight(asked)
    if one is None or two is None or asked.graph.over(one) or asked.graph.over(two):
        return None
    letter = _larger(asked.form, one, two)
    return FirstLookAnswer(letter, _reason(asked.form, letter, (one, two), say))


PLAN = TypePlan(_begin, _at_sight)
