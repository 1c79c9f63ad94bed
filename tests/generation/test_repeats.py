"""A suite asks about each pair of things once, whoever makes its tasks."""

from __future__ import annotations

from collections import Counter
from dataclasses import replace

import pytest

from probe.generation.build_folder import KEPT, REPEATED, BuildFolder, CandidateLog, TaskSlot
from probe.generation.repeats import repeated, roles_of, turned_back
from probe.tasks.suite import freeze
from probe.tasks.suite_file import demo_suite, find_suite, read_suite, write_suite
from probe.tasks.task import Task

BENEATH, COUNT = (
    next(task for task in demo_suite().tasks if task.question_type == it)
    for it in ("beneath", "count")
)


def placed(tasks: list[Task]) -> dict[TaskSlot, Task]:
    return {TaskSlot(task.question_type, n): task for n, task in enumerate(tasks)}


def test_the_roles_of_a_task_are_what_decides_it_and_what_hides_that():
    (hidden,) = BENEATH.targets
    names = {item.instance: item.object_id for item in BENEATH.scene.objects}
    assert BENEATH.cover is not None
    assert roles_of(BENEATH) == ("beneath", {names[hidden], names[BENEATH.cover]})
    counted = {names_of(COUNT)[instance] for instance in COUNT.targets}
    assert roles_of(COUNT)[1] >= counted and len(counted) == 1


def test_where_no_single_thing_hides_what_decides_all_that_is_to_go_counts():
    """Reduce in v2: of 16 things that several slabs hide, each could be asked about once only."""
    task = next(it for it in find_suite("v2").tasks if it.question_type == "reduce")
    (hidden,) = task.targets
    assert task.cover is None and len(task.named) >= 1
    assert roles_of(task)[1] == {names_of(task)[it] for it in (hidden, *task.named)}


def names_of(task: Task) -> dict[int, str]:
    return {item.instance: item.object_id for item in task.scene.objects}


def test_the_later_of_two_tasks_about_the_same_things_repeats_the_other():
    assert repeated(placed([BENEATH, COUNT])) == ()
    assert repeated(placed([BENEATH, BENEATH, COUNT, BENEATH])) == (
        TaskSlot("beneath", 1),
        TaskSlot("beneath", 3),
    )


def test_counts_of_none_are_about_what_is_counted():
    none = replace(COUNT, targets=(), cover=None)
    assert roles_of(none) == ("count", {none.subject})
    assert repeated(placed([none, replace(none, subject="blue cup")])) == ()


def test_pairs_that_v1_has_several_times_are_found():
    """An independent count of its marked pairs: 17 objects in 17 pairs, on 24 tables."""
    tasks = [task for task in find_suite("v1").tasks if task.question_type == "compare"]
    pairs = Counter(frozenset(names_of(task)[n] for n in task.targets) for task in tasks)
    more = sum(count - 1 for count in pairs.values())
    assert more > 0
    assert len(repeated(placed(tasks))) == more


@pytest.fixture
def parts(tmp_path, library) -> BuildFolder:
    folder = BuildFolder(tmp_path)
    for number, task in enumerate([BENEATH, BENEATH, BENEATH]):
        place = TaskSlot("beneath", number)
        task = replace(task, version=3 if number else 2)
        for seed, check in ((1, "settle"), (task.seed, KEPT)):
            folder.add(place, CandidateLog("beneath", seed, check, None, "", 1.0))
        write_suite(folder.task_path(place), freeze("one", (task,), library))
    return folder


def test_a_repetition_is_turned_back_and_its_place_goes_on_with_the_next_candidate(parts):
    first, second, third = places = [TaskSlot("beneath", number) for number in range(3)]
    assert turned_back(parts, places) == (third,)  # the first is of the older rules
    assert [it.check for it in parts.log(third)] == ["settle", REPEATED]
    _, roles = roles_of(BENEATH)
    told = parts.log(third)[1].detail
    assert "same things" in told and not any(id in told for id in roles)  # logs may be published
    assert not parts.task_path(third).exists()
    assert [it.check for it in parts.log(second)] == ["settle", KEPT]
    assert read_suite(parts.task_path(first)).tasks
    assert turned_back(parts, places) == ()
    # Another process that read the same folder before does no harm.
    parts.turn_back(third, BENEATH, "again")
    assert [it.check for it in parts.log(third)] == ["settle", REPEATED]
