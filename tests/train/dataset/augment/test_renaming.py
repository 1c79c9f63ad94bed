"""Other names: all that is said of a thing goes along, and nothing else changes."""

from __future__ import annotations

import re
from dataclasses import replace

import numpy as np
import pytest

from packed_teacher import names_in, said_in
from probe.agents.cover_nouns import hider
from probe.agents.reading import read_graph
from probe.tasks.english import plural
from probe.tasks.task import NONE_OF_THE_ABOVE
from probe.train.collect.teacher import speaker
from probe.train.dataset.augment.augmenting import augmented
from probe.train.dataset.augment.certain import NotCertain
from probe.train.dataset.augment.renaming import descriptions_in, renamed
from probe.train.dataset.augment.rewording import worded


@pytest.fixture(scope="module")
def known(episodes):
    return descriptions_in(record for _, record in episodes)


def with_other_names(task, record, known, seed=0):
    rng = np.random.default_rng(seed)
    return renamed(task, record, rng, speaker(task, record.run), known)


def test_every_name_is_another_one_in_all_that_is_said(episodes, known):
    told = 0
    for task, record in episodes:
        if task.question_type == "compare":
            continue
        now, after = with_other_names(task, record, known)
        before = {name for names in names_in(record) for name in names if name}
        pairs = {
            pair
            for olds, news in zip(names_in(record), names_in(after), strict=True)
            for pair in zip(olds, news, strict=True)
        }
        renames = dict(pairs)
        assert len(renames) == len(pairs) == len({*renames.values()})
        assert [old for old, new in pairs if old == new] in ([], [None])
        assert (None in renames) == (None in renames.values())
        named = [(old, new) for old, new in pairs if old and new]
        assert all(hider(old) == hider(new) for old, new in named)
        texts = said_in(after)
        for new in sorted((it for _, it in named), key=len, reverse=True):
            texts = texts.replace(new, "")  # "herring can" has an old name in it
        assert not [it for it in before if re.search(rf"(?<![\w-]){re.escape(it)}(?![\w-])", texts)]
        for (letter, old), (same, new) in zip(
            record.question.options, after.question.options, strict=True
        ):
            assert letter == same and (new == renames[old] if old in renames else True)
        assert [it.text for it in now.options] == [text for _, text in after.question.options]
        assert (now.answer, after.answer) == (task.answer, record.answer)
        told += 1
    assert told > 15


def test_numbers_none_and_marks_stay(episodes, known):
    for task, record in episodes:
        if task.question_type == "compare":
            continue
        _, after = with_other_names(task, record, known)
        for (_, old), (_, new) in zip(record.question.options, after.question.options, strict=True):
            kept = old == NONE_OF_THE_ABOVE or old.isdecimal() or old.startswith("Object ")
            assert (old == new) is kept


def test_descriptions_go_with_their_names(episodes, known):
    task, record = next(it for it in episodes if it[0].question_type == "count")
    _, after = with_other_names(task, record, known)
    graphs = [read_graph(it.text) for it in after.steps if it.call.name == "perceive_scene"]
    named = [seen for graph in graphs for seen in graph.named]
    assert named and all(known[seen.name or ""] == seen.description for seen in named)


def test_what_is_counted_has_its_plural(episodes, known):
    task, record = next(it for it in episodes if it[0].question_type == "count")
    now, after = with_other_names(task, record, known)
    assert now.subject != task.subject and now.subject in known
    assert task.subject not in after.question.text
    assert (plural(now.subject) or "no plural") in after.question.text
    assert after.question.text == now.question


LAMP = "white flashlight"


def with_a_reply_of(record, name):
    """An episode in which the first grasp or push has also moved something that no list has."""
    first = next(step for step in record.steps if "Manipulations left" in step.text)
    more = f"Also in the basket now: {name}. Manipulations left"
    told = replace(first, text=first.text.replace("Manipulations left", more))
    return replace(record, steps=tuple(told if it is first else it for it in record.steps))


def test_names_that_only_a_reply_has_are_changed_or_it_is_left_out(episodes, known):
    task, record = next(it for it in episodes if it[0].question_type == "reduce")
    told = with_a_reply_of(record, LAMP)
    with_it = {**known, LAMP: "A white flashlight."}
    _, after = with_other_names(task, told, with_it)
    assert LAMP not in said_in(after) and "Also in the basket now: " in said_in(after)
    without = {name: it for name, it in known.items() if name != LAMP}
    with pytest.raises(NotCertain, match="a reply names something that no list has"):
        with_other_names(task, told, without)


def test_a_name_that_is_a_colour_is_left_out(episodes, known):
    """Descriptions of parts have it, too: "orange, what shows is long"."""
    task, record = next(it for it in episodes if it[0].question_type == "find")
    name = next(iter(names_in(record)[0]))
    steps = tuple(replace(it, text=it.text.replace(f'"{name}"', '"orange"')) for it in record.steps)
    with pytest.raises(NotCertain, match="a name is a colour"):
        with_other_names(task, replace(record, steps=steps), known)


def test_a_question_with_a_name_that_no_list_has_is_left_out(episodes, known):
    task, record = next(it for it in episodes if it[0].question_type == "reduce")
    text = worded(task, record).wording.text.format(names="the glass unicorn")
    told = replace(record, question=replace(record.question, text=text))
    with pytest.raises(NotCertain, match="its question may have a name that no list has"):
        with_other_names(replace(task, question=text, subject=""), told, known)


def test_without_other_names_it_is_left_out(episodes):
    task, record = next(it for it in episodes if it[0].question_type == "find")
    with pytest.raises(NotCertain, match="too few other names"):
        with_other_names(task, record, descriptions_in([record]))


def test_names_come_from_all_lists_of_a_selection(episodes, known):
    count = [it for it in episodes if it[0].question_type == "count"]
    others = [it for it in episodes if it[0].question_type == "compare"]
    alone, together = (augmented(some, ["names"], 0) for some in (count[:1], [*others, count[0]]))
    assert not alone.episodes
    ((_, _, told),) = (it for it in together.episodes if it[1].question_type == "count")
    listed = {name for names in names_in(told) for name in names}
    assert listed - {None} <= {*known}


def test_the_draw_alone_decides(episodes, known):
    task, record = next(it for it in episodes if it[0].question_type == "find")
    told = [with_other_names(task, record, known, seed)[1] for seed in (1, 1, 2)]
    assert told[0] == told[1] != told[2]
