"""What a film says beside its pictures: calls, words, results, in a few lines each."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, cast

from probe.episodes.record import EpisodeRecord
from probe.episodes.turns import Call
from probe.film.footage import FilmedCall
from probe.tasks.grading import Score
from probe.texts import visible
from probe.toolshed.result import Answer

_LONGEST = 420
"""Characters of a text that are shown."""


@dataclass(frozen=True)
class Caption:
    """Texts beside one call.

    Attributes:
        heading: Which call it is.
        words: What the agent said along with it; empty if it said nothing.
        call: The tool and its arguments.
        result: What the agent read, or the gist of a list; of an answer, what it is worth.
        bad: Whether it failed, or the answer is wrong.
    """

    heading: str
    words: str
    call: str
    result: str
    bad: bool

    @property
    def signs(self) -> tuple[int, int]:
        """How much there is to read before and after the call is done."""
        return len(self.words) + len(self.call), len(self.result)


def captions_of(
    calls: Sequence[FilmedCall], record: EpisodeRecord, score: Score
) -> tuple[Caption, ...]:
    """A caption for each call; the last one of an answer says what that is worth."""
    captions: list[Caption] = []
    for number, each in enumerate(calls, start=1):
        answer = record.answer if number == len(calls) else None
        captions.append(
            Caption(
                f"Call {number} of {len(calls)}",
                _short(each.call.words),
                call_words(each.call),
                _result_words(each, answer, score),
                each.result.status != "done" or (answer is not None and not score.correct),
            )
        )
    return tuple(captions)


def call_words(call: Call) -> str:
    """A call as one would write it: push(object_id=object_3, direction=left)."""
    if not isinstance(call.values, dict):
        return _short(f"{call.name}({call.values})")
    values = cast(dict[str, Any], call.values)
    told = ", ".join(f"{name}={value}" for name, value in values.items())
    return _short(f"{call.name}({told})")


def _result_words(each: FilmedCall, answer: Answer | None, score: Score) -> str:
    text = each.result.text
    if each.call.name == "perceive_scene" and each.result.status == "done":
        things = text.count("- number:")
        return f"A list of {things} things." if things else _short(text)
    if answer is not None:
        return f"Answer {answer.choice}: {'right' if score.correct else 'wrong'}."
    return _short(text)


def _short(text: str) -> str:
    """A text as it can be shown, cut where it is too long."""
    seen = visible(text).strip()
    return seen if len(seen) <= _LONGEST else seen[: _LONGEST - 3].rstrip() + "..."
