from dataclasses import replace

from probe.agents.question_classifier import most_likely
from probe.episodes.grading import question_of
from probe.shortcuts.learning import learn
from probe.tasks.task import LETTERS, NONE_OF_THE_ABOVE, Option, Task
from task_examples import FIND

TEXTS = ("plum", "lime", "egg", "walnut")


def task(number: int, question: str, right: int) -> Task:
    """Its options are turned by its number, so that no letter is right more often."""
    turned = [TEXTS[(number + place) % 4] for place in range(4)] + [NONE_OF_THE_ABOVE]
    options = tuple(Option(o, text) for o, text in zip(LETTERS, turned, strict=True))
    answer = LETTERS[turned.index((*TEXTS, NONE_OF_THE_ABOVE)[right])]
    return replace(FIND, id=f"find-{number:03}", question=question, options=options, answer=answer)


TASKS = [task(n, "Which is it, if any?" if n % 3 == 0 else "Which?", 4 if n % 3 == 0 else 2)
         for n in range(60)]  # fmt: skip


def test_it_learns_words_of_options_and_questions():
    (question_type,) = (learnt := learn(TASKS).root)
    assert (question_type, learnt[question_type].tasks) == ("find", 60)
    rule = most_likely(learnt["find"].weights)
    assert all(rule(question_of(task)) == task.answer for task in TASKS)


def test_the_order_of_tasks_and_repeats_change_nothing():
    assert learn([*TASKS[::-1], TASKS[0]]).model_dump_json() == learn(TASKS).model_dump_json()


def test_too_little_to_learn_from_gives_no_weights():
    assert learn(TASKS[:1]).root["find"].weights == {}
