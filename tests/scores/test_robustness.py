import pytest

from probe.scores.robustness import NoCounterpart, shifts
from score_rows import faulty, roster, row

PLAIN = [row("find-1"), row("find-2"), row("size-1"), row("size-2", False)]
ROSTER = roster("find-1", "find-2", "size-1", "size-2")
LABEL = "camera tilted"
SETTING = f"agentic, {LABEL}"


def tilted(*rights: object):
    tasks = ("find-1", "find-2", "size-1", "size-2")
    return [row(task, right, setting=SETTING) for task, right in zip(tasks, rights, strict=True)]


def test_an_agent_is_compared_with_itself():
    (shift,) = shifts(PLAIN, {LABEL: tilted(1, 0, 0, 0)}, {LABEL: ["size-1"]}, ROSTER)
    assert (shift.conditions, shift.pair.tasks, shift.missing) == (LABEL, 4, 0)
    assert (shift.plain, shift.other) == (0.75, 0.25)
    assert shift.pair.difference == pytest.approx(-0.5)
    # Without size-1: find -1/2, size 0.
    assert (shift.certified, shift.certified_tasks) == (-0.25, 3)


def test_several_conditions_are_one_family():
    others = {
        LABEL: tilted(0, 0, 0, 0),
        "table other": [row("find-1", 0, setting="agentic, table other")],
    }
    one, other = shifts(PLAIN, others, {}, ROSTER)
    assert (one.conditions, other.conditions) == (LABEL, "table other")
    assert one.pair.adjusted >= one.pair.p
    assert (other.pair.tasks, other.pair.left_out, other.missing) == (1, 3, 3)


def test_what_is_missing_is_counted():
    plain = [*PLAIN[:3], faulty("size-2")]
    rows = [faulty("find-1", setting=SETTING), *tilted(1, 1, 1, 1)[1:]]
    (shift,) = shifts(plain, {LABEL: rows}, {}, ROSTER)
    assert (shift.missing, shift.pair.tasks) == (2, 2)


def test_no_certified_difference_where_no_task_holds():
    broken = [it.task for it in PLAIN]
    (shift,) = shifts(PLAIN, {LABEL: tilted(1, 0, 0, 0)}, {LABEL: broken}, ROSTER)
    assert (shift.certified, shift.certified_tasks) == (None, 0)


def test_somebody_else_is_no_comparison():
    rows = [row("find-1", agent="bob", setting=SETTING)]
    match = "bob was run under 'camera tilted'.*Run the same agent on both"
    with pytest.raises(NoCounterpart, match=match):
        shifts(PLAIN, {LABEL: rows}, {}, ROSTER)
    with pytest.raises(NoCounterpart, match=match):
        shifts(PLAIN, {LABEL: [*tilted(1, 1, 1, 1), *rows]}, {}, ROSTER)
