from dataclasses import replace

import pytest

from played_examples import played, report_of
from probe.report.result_words import result_words
from probe.scores.summary import Scores
from run_folders import DEMO, episode


def words(*right: tuple[str, int]) -> str:
    """Of agents that were right in the first so many of the six tasks."""
    episodes = [
        played(episode(task, agent=name, right=number < count))
        for name, count in right
        for number, task in enumerate(DEMO.tasks)
    ]
    return shown(report_of(episodes).scores)


def shown(scores: Scores) -> str:
    signs = {"\N{FIRST STRONG ISOLATE}": "", "\N{POP DIRECTIONAL ISOLATE}": ""}
    text = result_words(scores).replace("\N{NARROW NO-BREAK SPACE}", " ")
    return text.translate(str.maketrans(signs))


def test_one_agent_has_its_score_its_interval_and_chance_beside_it():
    said = "anna (agentic) scored 100 % on 6 tasks (95 % interval 62 to 100 %)."
    assert words(("anna", 6)) == f"{said} A blind guess scores 20 %."


def test_who_scored_highest_is_named_and_whom_six_tasks_cant_tell_from_it():
    said = words(("anna", 6), ("bert", 0), ("carl", 5))
    assert said.startswith("anna (agentic) scored highest of 3: 100 % on 6 tasks")
    few = "These are too few tasks to tell anna (agentic) from"
    assert said.endswith(f"{few} carl (agentic) and bert (agentic).")


def test_two_who_scored_alike_are_both_named():
    assert words(("anna", 6), ("bert", 6)).startswith(
        "anna (agentic) and bert (agentic) both scored"
    )


def test_differences_that_were_shown_are_said_to_be():
    scores = report_of(
        [played(episode(task, agent=who)) for task in DEMO.tasks for who in ("anna", "bert")]
    ).scores
    (pair,) = scores.all_pairs
    shown_to_differ = replace(scores, all_pairs=(replace(pair, tie=False),))
    assert shown(shown_to_differ).endswith("The difference from every other is more than chance.")


def test_missing_runs_leave_no_score():
    one = report_of([played(episode(DEMO.tasks[0]))]).scores
    assert shown(one) == (
        "Incomplete: 5 of 6 runs are missing. "
        "The score of anna (agentic) lies between 17 % and 100 %."
    )
    assert shown(report_of([]).scores) == "No episode was played."


def test_many_are_counted():
    said = words(*((name, 6) for name in "abcde"))
    assert said.startswith("5 agents all scored 100 %")


@pytest.mark.parametrize("name", ["\u202eevil", "<b>"])
def test_a_name_is_isolated(name):
    text = result_words(report_of([played(episode(DEMO.tasks[0], agent=name))]).scores)
    assert f"\u2068{name} (agentic)\u2069" in text
