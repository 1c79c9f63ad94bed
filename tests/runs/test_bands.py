from dataclasses import replace

import pytest

from probe.runs.bands import broken_rule
from probe.scene.visibility import Visibility
from probe.tasks.suite_file import demo_suite

BENEATH, _, COUNT, _, FIND, _ = demo_suite().tasks


def seen(task, **shares):
    """What was measured, but for some objects: share of 10,000 pixels by "_7" and the like."""
    changed = {int(name[1:]): Visibility(round(1e4 * s), 10_000) for name, s in shares.items()}
    return {**task.certificate.visibility, **changed}


@pytest.mark.parametrize("task", demo_suite().tasks)
def test_rules_hold_for_what_was_certified(task):
    assert broken_rule(task, task.certificate.visibility) is None


def test_a_hidden_thing_must_stay_hidden():
    (target,) = BENEATH.targets
    assert broken_rule(BENEATH, seen(BENEATH, **{f"_{target}": 0.012})) is None
    words = broken_rule(BENEATH, seen(BENEATH, **{f"_{target}": 0.04}))
    # 4 % are few, but 400 pixels are many.
    assert words == f"object {target} was hidden, is between (4% visible)"


def test_counted_things_must_stay_clear():
    clear = [n for n in COUNT.targets if COUNT.certificate.visibility[n].fraction >= 0.5]
    words = broken_rule(COUNT, seen(COUNT, **{f"_{clear[0]}": 0.45}))
    assert words == f"object {clear[0]} was clear, is between (45% visible)"


def test_marked_things_must_show_a_little():
    frozen = {1: Visibility(900, 10_000), 2: Visibility(2_000, 10_000)}
    task = replace(
        FIND,
        question_type="size",
        targets=(1, 2),
        certificate=replace(FIND.certificate, visibility=frozen),
    )
    assert broken_rule(task, {**frozen, 1: Visibility(3_400, 10_000)}) is None
    assert broken_rule(task, {**frozen, 2: Visibility(3_600, 10_000)}) == (
        "object 2 was little, is between (36% visible)"
    )
