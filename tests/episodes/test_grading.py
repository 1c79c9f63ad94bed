from dataclasses import replace

import numpy as np
import pytest

from probe.episodes.grading import OtherTask, answer_form, grade_episode, question_of
from probe.tasks.suite_file import packaged_suite
from probe.tasks.task import Certificate, Option, Task
from probe.toolshed.answer_form import AnswerForm
from task_examples import FIND


def task_of(record, **changes):
    task = Task(
        id="t-1",
        question_type="count",
        form="plain",
        seed=1,
        subject="ball",
        question="Where is the ball?",
        options=(Option("A", "here"), Option("B", "there")),
        answer="B",
        scene=record.start.scene,
        targets=(9,),
        cover=None,
        named=(),
        marks=(),
        certificate=Certificate({}, {}, ()),
    )
    return replace(task, **changes)


LABELS = np.zeros((8, 8), np.int32)


def test_the_letter_is_graded_from_the_record_alone(play):
    record = play()
    assert grade_episode(task_of(record), record, LABELS).correct
    assert not grade_episode(task_of(record, answer="A"), record, LABELS).correct


def test_find_looks_at_the_point(play):
    record = play()
    task = task_of(record, question_type="find")
    labels = np.zeros((1024, 1024), np.int32)
    labels[480:500, 630:650] = 9
    assert grade_episode(task, record, labels).outcome == "right"
    assert grade_episode(task, record, np.roll(labels, 100, axis=1)).outcome == "missed"


def test_no_answer_is_unanswered(play):
    record = replace(play(), answer=None, end="stopped")
    assert grade_episode(task_of(record), record, LABELS).outcome == "unanswered"


def test_another_task_is_refused(play):
    record = play()
    with pytest.raises(OtherTask, match="suite that it was run on"):
        grade_episode(task_of(record, id="t-2"), record, LABELS)


def test_an_agent_is_told_words_and_options_alone(play):
    question = question_of(task_of(play()))
    assert question.options == (("A", "here"), ("B", "there"))
    assert set(vars(question)) == {"text", "options", "picture", "scale", "manipulations"}
    assert question.manipulations is None


def test_a_complete_answer_has_a_letter_of_the_task_and_where_asked_a_point():
    letters = ("A", "B", "C", "D", "E")
    assert answer_form(FIND) == AnswerForm(letters, letters[:4])
    forms = {task.question_type: answer_form(task) for task in packaged_suite("v1").tasks}
    assert forms["find"] == AnswerForm(letters, letters[:4])
    assert forms["beneath"] == AnswerForm(letters)
    assert forms["size"] == AnswerForm(("A", "B"))
