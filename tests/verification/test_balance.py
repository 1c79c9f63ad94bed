"""Counts that a guesser could lean on."""

from __future__ import annotations

from dataclasses import replace

from probe.tasks.suite_file import demo_suite, packaged_suite
from probe.verification.balance import Balance, balances


def test_values_may_differ_by_one():
    assert Balance("find", "letter", {"A": 2, "B": 1}).even
    assert not Balance("find", "letter", {"A": 2, "B": 0}).even


def test_letters_are_counted_with_those_that_never_occur():
    task = next(task for task in demo_suite().tasks if task.question_type == "find")
    tasks = [replace(task, answer=letter) for letter in "AABC"]
    (found,) = balances(tasks)
    assert found.counts == {"A": 2, "B": 1, "C": 1, "D": 0, "E": 0} and not found.even


def test_count_crosses_clear_and_hidden():
    task = next(task for task in demo_suite().tasks if task.question_type == "count")
    _, crossed = balances([task])
    assert len(crossed.counts) == 12 and sum(crossed.counts.values()) == 1
    _, to_six = balances([replace(task, version=3)])
    assert len(to_six.counts) == 15 and to_six.counts["4 clear, 2 hidden"] == 0


def test_size_crosses_what_shows_of_the_larger_thing():
    leads = {"area_lead": 0.1, "length_lead": -0.2, "outline_lead": 0.1}
    task = next(task for task in packaged_suite("v1").tasks if task.question_type == "size")
    proof = replace(task.certificate, measures={**task.certificate.measures, **leads})
    *_, crossed = balances([replace(task, certificate=proof)])
    assert crossed.of == "what shows of the larger"
    deep = {"cover_height_lead": 0.1, "height_lead": -0.1}
    proof = replace(proof, measures={**proof.measures, **deep})
    *_, depth = balances([replace(task, certificate=proof, version=3)])
    assert len(depth.counts) == 4
    assert depth.counts["cover higher: True, thing higher: False"] == 1
    assert len(crossed.counts) == 4 and crossed.counts["more: True, longer: False"] == 1
