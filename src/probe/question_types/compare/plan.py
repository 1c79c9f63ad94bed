"""How the scripted agent goes about Compare: by the colours that descriptions name first."""

from __future__ import annotations

import re
from collections.abc import Sequence

from probe.agents.clearing import Search
from probe.agents.marks import Both, guess_mark, marked_at_sight, uncover_both
from probe.agents.moves import Plan, answer
from probe.agents.phrases import Say
from probe.agents.reading import Seen
from probe.agents.type_plan import FirstLookAnswer, FirstLookQuestion, ScriptedQuestion, TypePlan

_MIDDLE = 50
"""L* of what isn't known."""

# L* of what these words usually mean, rounded.
_LIGHTNESS = {
    "black": 10, "dark": 25, "brown": 35, "purple": 38, "blue": 40, "red": 45, "green": 48,
    "gray": 50, "grey": 50, "teal": 52, "gold": 65, "orange": 65, "tan": 70, "pink": 72,
    "silver": 72, "beige": 82, "yellow": 84, "light": 78, "cream": 90, "white": 95,
}  # fmt: skip


def _begin(asked: ScriptedQuestion) -> Plan[None]:
    """Uncover both marked things and go by the colours that their descriptions name first."""
    form, bold, say = asked.form, asked.bold, asked.say
    search = Search.of(asked)
    yield from search.begin()
    like = search.graph.called(asked.subject) if form == "like" else ()
    wanted = _wanted_colour(form, asked.subject, like)
    both: Both = (None, None)
    letter: str | None = None
    if wanted or form == "darker":
        search.remark(say(f"asked {form}", {"colour": " ".join(wanted), "thing": asked.subject}))
        both = yield from uncover_both(asked.question, search, bold=bold, call=_with_colour)
        letter = _fitting(form, wanted, both) if bold or all(both) else None
    if letter and all(both):
        words = search.after_remarks(_reason(asked, letter, wanted, both, say))
        yield from answer(letter, words=words)
    elif letter:
        yield from answer(letter, words=say("guess", {"letter": letter}))
    elif bold:
        yield from guess_mark(asked.rng, say)


def _wanted_colour(form: str, subject: str, like: Sequence[Seen]) -> list[str]:
    """The word of the colour that is asked for; none if that isn't known.

    Args:
        form: What exactly is asked.
        subject: The colour itself, or the thing that has it.
        like: What goes by that thing's name.
    """
    if form == "like":
        return _colours(like[0])[:1] if like else []
    return _words(subject)[-1:]


def _fitting(form: str, wanted: Sequence[str], both: Both) -> str | None:
    """Letter of the one whose colour is asked for; None if that can't be told.

    Of one alone it goes by what it is: only one of the two has the colour.
    """
    a, b = (_colours(seen)[:1] if seen else [] for seen in both)
    if form == "darker":
        light = [_LIGHTNESS[words[0]] if words else _MIDDLE for words in (a, b)]
        fits = [light[0] < light[1], light[1] < light[0]]
    else:
        fits = [bool(words) and words[0] == wanted[0] for words in (a, b)]
        # One that is known not to have it leaves the other.
        fits = fits if any(fits) else [bool(b), bool(a)]
    return None if fits[0] == fits[1] else "A" if fits[0] else "B"


def _colours(seen: Seen) -> list[str]:
    return _words(f"{seen.name or ''} {seen.description}")


def _with_colour(seen: Seen) -> str:
    """Its name, and its colour where the name tells none."""
    name, colours = seen.name or "", _colours(seen)
    return name if _words(name) or not colours else f"{name} ({colours[0]})"


def _words(text: str) -> list[str]:
    """Colour words in the order in which a text names them; "dark" and "light" are shades."""
    found = [word for word in re.findall(r"[a-z]+", text.lower()) if word in _LIGHTNESS]
    plain = [word for word in found if word not in ("dark", "light")]
    return plain or found


def _at_sight(asked: FirstLookQuestion, say: Say) -> FirstLookAnswer | None:
    """By colour one of the two that can be named is enough: just one has the colour."""
    both = marked_at_sight(asked)
    like = asked.graph.called(asked.subject) if asked.form == "like" else ()
    wanted = _wanted_colour(asked.form, asked.subject, like)
    named = [seen for seen in both if seen is not None]
    if not named or (asked.form == "darker" and len(named) < 2):
        return None
    if not wanted and asked.form != "darker":
        return None
    letter = _fitting(asked.form, wanted, both)
    if letter is None:
        return None
    return FirstLookAnswer(letter, _reason(asked, letter, wanted, both, say))


def _reason(
    asked: ScriptedQuestion | FirstLookQuestion,
    letter: str,
    wanted: Sequence[str],
    both: Both,
    say: Say,
) -> str:
    """Why it is that letter: by both colours where these decide it, else by one alone."""
    one, two = both
    first = [_colours(seen)[:1] if seen else [] for seen in both]
    chosen = "AB".index(letter)
    if one and two and all(first) and (asked.form == "darker" or first[chosen] == wanted):
        slots = {"one": one.name or "", "two": two.name or "", "letter": letter}
        slots |= {"colour_one": first[0][0], "colour_two": first[1][0]}
        slots |= {"colour": first[chosen][0]}
        return say("compare darker" if asked.form == "darker" else "compare colour", slots)
    if asked.form == "darker":
        return say("guess", {"letter": letter})
    fits = first[chosen] == wanted
    told = both[chosen if fits else 1 - chosen]
    slots = {"thing": (told and told.name) or "", "letter": letter}
    return say("sight colour one" if fits else "sight colour other", slots)


PLAN = TypePlan(_begin, _at_sight)
