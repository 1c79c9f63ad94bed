"""Other names in Compare: whichever thing has the colour that is asked for now is right."""

from __future__ import annotations

import re

import numpy as np
import pytest

from packed_teacher import all_episodes, names_in
from probe.tasks.wordings import wordings
from probe.train.collect.teacher import speaker
from probe.train.dataset.augment.renaming import descriptions_in, renamed
from probe.train.dataset.augment.rewording import worded

# By eye.
DARK, LIGHT = ("black", "brown", "purple"), ("white", "yellow", "beige")


@pytest.fixture(scope="module")
def packed(tmp_path_factory):
    """All packed episodes; few of each form of Compare are right."""
    return all_episodes(tmp_path_factory.mktemp("packed"))


@pytest.fixture(scope="module")
def known(packed):
    return descriptions_in(record for _, record in packed)


@pytest.fixture(scope="module")
def told(packed, known):
    """Compare before and after, each in two ways."""
    found = []
    for task, record in packed:
        given = record.answer and record.answer.choice
        if task.question_type != "compare" or given != task.answer:
            continue
        for seed in (0, 1):
            rng = np.random.default_rng(seed)
            again = renamed(task, record, rng, speaker(task, record.run), known)
            found.append(((task, record), again))
    return found


def colours_by_letter(record):
    ((one, two),) = re.findall(r"(\w+) is A; (\w+) is B\b", record.steps[-1].call.words)
    return {"A": one, "B": two}


def test_all_forms_are_told_with_each_letter(told):
    for form in ("colour", "darker", "like"):
        assert {now.answer for (task, _), (now, _) in told if task.form == form} == {"A", "B"}


def test_the_answer_given_is_right_and_its_colour_is_asked_for(told, known):
    for _, (now, after) in told:
        assert now.answer == after.answer.choice == after.steps[-1].call.values["choice"]
        colours = colours_by_letter(after)
        right, other = colours[now.answer], colours["B" if now.answer == "A" else "A"]
        assert right != other
        if now.form == "colour":
            assert now.subject == right and re.search(rf"\b{right}\b", now.question)
        elif now.form == "like":
            assert now.subject in now.question
            assert right in f"{now.subject} {known[now.subject]}".lower()
        else:
            assert not (right in LIGHT and other in DARK)


def test_each_marked_thing_has_the_colour_that_is_said_of_it(told, known):
    for _, (_, after) in told:
        words = " ".join(step.call.words for step in after.steps)
        last = {  # a thing may be named more than once as it comes to light
            letter: re.sub(r" \(\w+\)$", "", name)
            for letter, name in re.findall(r"Mark ([AB]) (?:is|may be) \w+, the ([^.]*)\.", words)
        }
        colours = colours_by_letter(after)
        for letter, name in last.items():
            assert colours[letter] in f"{name} {known[name]}".lower()


def test_all_names_are_others_and_the_question_is_the_same_but_for_its_slot(told):
    for (task, record), (now, after) in told:
        before = {name for names in names_in(record) for name in names if name}
        texts = {name for names in names_in(after) for name in names if name}
        assert before and not before & texts
        assert now.question == after.question.text
        assert worded(now, after).wording == worded(task, record).wording
        assert worded(now, after).wording in wordings("compare")
