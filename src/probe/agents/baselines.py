"""Agents that answer at once, by a rule: floors that every score should be compared with."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence

from probe.agents.moves import none_of_them
from probe.episodes.turns import Call, Question, Turn

Rule = Callable[[Question], str | None]
"""A letter that a question offers; None to give no answer."""

_NUMBER = re.compile(r"\d+")


class AtOnce:
    """Answers at once by a rule, without a look at anything; an Agent.

    It never points. Where that is asked for, its answer is refused once, and it repeats it.
    """

    def __init__(self, rule: Rule) -> None:
        self._rule = rule

    def act(self, question: Question, history: Sequence[Turn]) -> Call | None:
        """The answer; None where the rule has none."""
        letter = self._rule(question)
        return None if letter is None else Call.of("answer_question", {"choice": letter})


def always(letter: str) -> Rule:
    """Always the same letter; the last one that is offered where that one isn't."""

    def rule(question: Question) -> str:
        letters = [offered for offered, _ in question.options]
        return letter if letter in letters else letters[-1]

    return rule


def always_none(question: Question) -> str | None:
    """Always "None of the above"; no answer where that isn't offered."""
    return none_of_them(question)


def middle_number(question: Question) -> str:
    """The middle one of the numbers that are offered, the lower of two; else the first option."""
    numbers = sorted((value, letter) for letter, value in _numbers(question).items())
    return numbers[(len(numbers) - 1) // 2][1] if numbers else question.options[0][0]


def extreme(sizes: Mapping[str, float], areas: Mapping[str, float], *, largest: bool) -> Rule:
    """The option whose object is smallest, or largest; of numbers likewise.

    Args:
        sizes: Of objects, by the names that options use; options without one are left out.
        areas: Of what shows of the thing at each mark, by letter; empty where none are marked.
        largest: Which of the two.
    """

    def rule(question: Question) -> str:
        by_name = {letter: sizes[text] for letter, text in question.options if text in sizes}
        known = dict(areas) or _numbers(question) or by_name
        if not known:
            return question.options[0][0]
        return (max if largest else min)(sorted(known), key=lambda letter: known[letter])

    return rule


def _numbers(question: Question) -> dict[str, float]:
    return {letter: int(text) for letter, text in question.options if _NUMBER.fullmatch(text)}
