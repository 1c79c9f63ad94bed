"""Changed texts, and what the teacher says and answers then."""

from __future__ import annotations

from dataclasses import replace

import pytest

from probe.agents.phrases import silent
from probe.train.dataset.augment.certain import NotCertain
from probe.train.dataset.augment.retelling import (
    answered,
    changed,
    check_scripted,
    retold,
    with_its_answer,
)


@pytest.fixture(scope="module")
def found(first_batch):
    """A task of Find whose answer is A or B, and the teacher's episode."""
    of_find = [it for it in first_batch if it[0].question_type == "find" and it[1].answer]
    answers = ((it, it[1].answer.choice if it[1].answer else None) for it in of_find)
    return next(it for it, answer in answers if it[0].answer == answer in ("A", "B"))


def test_all_but_words_are_changed(found):
    task, record = found
    now, after = changed(task, record, str.upper)
    assert now.question == after.question.text == task.question.upper()
    assert [it.text for it in now.options] == [text.upper() for _, text in record.question.options]
    for old, new in zip(record.steps, after.steps, strict=True):
        assert new.text == old.text.upper() and new.call.words == old.call.words
        values = old.call.values.items()
        before = {key: it.upper() if isinstance(it, str) else it for key, it in values}
        assert new.call.values == before


def test_what_is_as_it_was_is_told_as_it_was(found):
    task, record = found
    now, after = retold(task, record, str, silent)
    assert now == task
    assert after.question == record.question
    calls = [[(it.call.name, it.call.values, it.text) for it in a.steps] for a in (record, after)]
    assert calls[0] == calls[1]
    assert {step.call.words for step in after.steps} == {""}


def test_the_teacher_gives_another_letter_where_another_option_is_true(found):
    task, record = found
    option = dict(record.question.options)[task.answer]
    swapped = {"A": task.options[1].text, "B": task.options[0].text}
    options = tuple(replace(it, text=swapped.get(it.letter, it.text)) for it in task.options)
    question = replace(record.question, options=tuple((it.letter, it.text) for it in options))
    asked = replace(record, question=question)
    told, after = with_its_answer(replace(task, options=options), asked, silent)
    assert told.answer != task.answer and dict(after.question.options)[told.answer] == option
    assert after.answer and after.answer.choice == told.answer
    assert after.steps[-1].call.values["choice"] == told.answer


def test_a_wrong_answer_is_no_ones_to_change(found):
    task, record = found
    other = next(it.letter for it in task.options if it.letter != task.answer)
    for wrong in (answered(record, other), replace(record, answer=None)):
        with pytest.raises(NotCertain, match="its answer wasn't right"):
            with_its_answer(task, wrong, silent)


def test_other_calls_must_be_the_same(found):
    task, record = found
    longer = replace(record, steps=(record.steps[0], *record.steps))
    with pytest.raises(NotCertain, match="would do something else today"):
        with_its_answer(task, longer, silent)


def test_only_the_scripted_teacher_can_be_asked_again(found):
    _, record = found
    check_scripted(record)
    with pytest.raises(NotCertain, match="isn't the scripted one"):
        check_scripted(replace(record, agent="a-model"))
    call = replace(record.steps[1].call, arguments="[]")
    steps = (record.steps[0], replace(record.steps[1], call=call), *record.steps[2:])
    with pytest.raises(NotCertain, match="a call is written in another way"):
        check_scripted(replace(record, steps=steps))
