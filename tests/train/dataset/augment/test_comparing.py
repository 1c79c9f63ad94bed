"""Which of two things is clearly the darker one, and is the teacher right about it?"""

from __future__ import annotations

import re

import pytest

from packed_teacher import names_in, right_darker
from probe.train.collect.teacher import speaker
from probe.train.dataset.augment.certain import NotCertain
from probe.train.dataset.augment.comparing import compared_again
from probe.train.dataset.augment.rephrasing import rephrased
from probe.train.dataset.augment.retelling import SlotListener, changed


@pytest.fixture(scope="module")
def darker(episodes):
    """A right episode that asks for the darker one, and what the two are called."""
    task, record = right_darker(episodes)
    listener = SlotListener(speaker(task, record.run), "colour_one")
    rephrased(task, record, listener)
    return task, record, (listener.heard["one"], listener.heard["two"])


def described(one: str, two: str, names: tuple[str, str]):
    """Changes a text: A is a jar and B a tin, with these descriptions."""

    def change(text: str) -> str:
        for old, new, said in zip(names, ("jar", "tin"), (one, two), strict=True):
            entry = rf'name: "{old}"(\n\s*description: )"[^\n]*"'
            text = re.sub(entry, rf'name: "{new}"\g<1>"{said}"', text).replace(old, new)
        return text

    return change


def answer_of(darker, one: str, two: str) -> str:
    task, record, names = darker
    now = changed(task, record, described(one, two, names))
    assert {"jar", "tin"} <= {name for listed in names_in(now[1]) for name in listed}
    return compared_again(record, lambda: now, speaker(task, record.run))[0].answer


def test_a_clear_difference_is_taken(darker):
    assert answer_of(darker, "A purple jar.", "A yellow tin.") == "A"
    assert answer_of(darker, "A light orange jar with a lid.", "A dark gray tin.") == "B"


@pytest.mark.parametrize(
    ("one", "two"),
    [
        ("A light purple jar.", "A green tin."),  # about the same; the teacher says A
        ("A light purple jar.", "A dark green tin."),  # B; the teacher says A
        ("A cream jar.", "A black tin."),  # the teacher knows more colours than have a meaning
    ],
)
def test_what_is_unclear_by_the_shade_is_not_taken(darker, one, two):
    with pytest.raises(NotCertain, match="no other colours decide clearly"):
        answer_of(darker, one, two)
