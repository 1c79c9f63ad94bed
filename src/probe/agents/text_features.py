"""A question and its options as numbers: what a classifier has that sees no picture."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence

Features = Mapping[str, float]
"""Numbers about one option, by name; what isn't there is 0."""

_WORD = re.compile(r"[a-z]+")
_NUMBER = re.compile(r"\d+")
_MARK = re.compile(r"\b[AB] at \((\d+), (\d+)\)")
_MARKS = " In the first picture, the marks are "
_MIDDLE_PX, _SCALE_PX = 512, 512
_LONG = 20


def position(options: Sequence[str]) -> tuple[Features, ...]:
    """Where each option stands; nothing else."""
    return tuple({f"@{place}": 1.0} for place in range(len(options)))


def wording(question: str, options: Sequence[str]) -> tuple[Features, ...]:
    """Which words go with which place."""
    words = _words(question.split(_MARKS)[0])
    return tuple(
        {f"@{place}": 1.0} | {f"{word}@{place}": 1.0 for word in words}
        for place in range(len(options))
    )


def texts(question: str, options: Sequence[str]) -> tuple[Features, ...]:
    """What each option says, wherever it stands, and how it differs from the others."""
    asked = _words(question.split(_MARKS)[0])
    spoken = [_words(text) for text in options]
    found: list[Features] = []
    for place, text in enumerate(options):
        words = spoken[place]
        others = [other for n, other in enumerate(spoken) if n != place and not is_none(options[n])]
        if is_none(text):
            found.append({"none": 1.0} | {f"{word} none": 1.0 for word in asked})
            continue
        features = {f"word {word}": 1.0 for word in words}
        features["length"] = len(text) / _LONG
        features["words"] = len(words) / 4
        features["in question"] = float(bool(words & asked))
        for word in words:
            features["shared"] = features.get("shared", 0.0) + sum(word in o for o in others) / 4
        found.append({**features, **_number(place, options), **_mark(place, question)})
    return tuple(found)


def _number(place: int, options: Sequence[str]) -> Features:
    """How a number lies among the others; nothing where options aren't numbers."""
    numbers = [int(text) for text in options if _NUMBER.fullmatch(text)]
    if not _NUMBER.fullmatch(options[place]):
        return {}
    value = int(options[place])
    rank = sum(number < value for number in numbers)
    near = sum(abs(number - value) == 1 for number in numbers)
    return {f"number {value}": 1.0, f"rank {rank}": 1.0, f"neighbours {near}": 1.0}


def _mark(place: int, question: str) -> Features:
    """Where the mark of Compare's and Size's option lies, and less the other one."""
    marks = [(u - _MIDDLE_PX, v - _MIDDLE_PX) for u, v in marks_in(question)]
    if len(marks) <= place:
        return {}
    (u, v), (other_u, other_v) = marks[place], marks[1 - place]
    apart = (u * u + v * v) ** 0.5 - (other_u**2 + other_v**2) ** 0.5
    values = {"right of": u - other_u, "below": v - other_v, "further out": apart}
    words = sorted(_words(question.split(_MARKS)[0]) & {"longer", "larger", "smaller", "darker"})
    scaled = {name: value / _SCALE_PX for name, value in values.items()}
    return scaled | {f"{word} {name}": x for word in words for name, x in scaled.items()}


def _words(text: str) -> set[str]:
    return set(_WORD.findall(text.lower()))


def marks_in(question: str) -> list[tuple[int, int]]:
    """Pixels (u, v) of the marks that a question tells of, A first."""
    return [(int(u), int(v)) for u, v in _MARK.findall(question)]


def is_none(text: str) -> bool:
    """Whether an option is "None of the above"."""
    return text.lower().startswith("none")
