from __future__ import annotations

from dataclasses import replace

import pytest

from lessons import begin_collection, lesson, suite_of, training_task, write_batch
from probe.episodes.files import read_records, write_records
from probe.episodes.folder import RECORDS, SUITE
from probe.errors import BadData
from probe.tasks.suite_file import write_suite
from probe.train.choose.gathering import candidates_of
from probe.train.collect.batches import GRADES, batches, collected
from probe.train.collect.settings import claim, read_settings

LESSONS = [
    lesson(training_task(1), setting="direct", right=False),
    lesson(training_task(1)),
    lesson(training_task(2), setting="direct"),
    lesson(training_task(3, "count"), right=False),
]


def test_episodes_come_back_with_their_tasks_and_grades(tmp_path):
    write_batch(begin_collection(tmp_path), LESSONS)
    objects = {}
    found, unfinished = candidates_of([tmp_path], objects)
    assert sorted(map(repr, found)) == sorted(map(repr, LESSONS)) and unfinished == 0
    assert len(objects) == 6 + len(training_task(3, "count").scene.objects)


def test_what_was_brought_is_counted_by_task(tmp_path):
    write_batch(begin_collection(tmp_path), LESSONS)
    so_far = collected(batches(tmp_path))
    assert (so_far.tasks, so_far.successes) == ({"find": 2, "count": 1}, {"find": 2})
    assert (so_far.episodes, so_far.cost) == (4, 1.0)
    assert (so_far.right, so_far.played) == (
        {"agentic": 1, "direct": 1}, {"agentic": 2, "direct": 2}
    )  # fmt: skip
    assert so_far.last == {"find": 2_000_002, "count": 2_000_003}


def test_what_was_right_without_tools_but_once_is_no_success(tmp_path):
    """It isn't learnt from either."""
    lucky = [
        lesson(training_task(1), setting="direct", run=run, right=run == 1) for run in range(3)
    ]
    sure = [lesson(training_task(2, "count"), setting="direct", run=run) for run in range(2)]
    write_batch(begin_collection(tmp_path), [*lucky, *sure, lesson(training_task(1), right=False)])
    assert collected(batches(tmp_path)).successes == {"count": 1}


def test_an_unfinished_batch_is_left_out(tmp_path):
    write_batch(begin_collection(tmp_path), LESSONS[:1])
    (write_batch(tmp_path, LESSONS[1:], "0of1-00001").folder / GRADES).unlink()
    found, unfinished = candidates_of([tmp_path], {})
    assert len(found) == 1 and unfinished == 1
    assert collected(batches(tmp_path)).episodes == 1


def test_a_record_that_is_cut_off_is_named(tmp_path):
    batch = write_batch(begin_collection(tmp_path), LESSONS)
    path = batch.setting("agentic") / "records.jsonl"
    path.write_bytes(path.read_bytes()[:-40])
    with pytest.raises(BadData, match=r"agentic/records.jsonl, line 2: .*run the episode again"):
        candidates_of([tmp_path], {})


def test_records_without_grades_and_grades_without_records_are_told(tmp_path):
    batch = write_batch(begin_collection(tmp_path), LESSONS)
    whole = batch.grades()
    batch.keep(whole[:-1])
    with pytest.raises(BadData, match="isn't graded. Delete its batch's grades.json"):
        candidates_of([tmp_path], {})
    batch.keep([*whole, whole[0].model_copy(update={"run": 5})])
    with pytest.raises(BadData, match="is graded but has no record"):
        candidates_of([tmp_path], {})


def test_a_fault_that_was_made_good_since_is_no_episode(tmp_path):
    batch = write_batch(begin_collection(tmp_path), LESSONS)
    good = LESSONS[1].record
    fault = replace(
        good, participation=None, end="fault", fault="gone", answer=None, steps=good.steps[:-1]
    )
    path = batch.setting("agentic") / RECORDS
    records = read_records(path)
    path.unlink()
    write_records(path, [fault, *records])
    found, _ = candidates_of([tmp_path], {})
    assert sorted(map(repr, found)) == sorted(map(repr, LESSONS))


def test_what_left_no_record_is_missing(tmp_path):
    batch = write_batch(begin_collection(tmp_path), LESSONS)
    lost = batch.grades()[0].model_copy(update={"run": 1, "correct": None})
    batch.keep([*batch.grades(), lost])
    found, _ = candidates_of([tmp_path], {})
    assert len(found) == len(LESSONS)
    assert collected(batches(tmp_path)).missing == 1


def test_another_part_of_the_tasks_is_another_collection(tmp_path):
    begin_collection(tmp_path)
    settings = read_settings(tmp_path)
    claim(tmp_path, settings)
    with pytest.raises(BadData, match="was begun with shard 0/1, not 1/2"):
        claim(tmp_path, settings.model_copy(update={"shard": "1/2"}))
    with pytest.raises(BadData, match="was begun with first 2000000, not 2500000"):
        claim(tmp_path, settings.model_copy(update={"first": 2_500_000}))


def test_one_id_for_two_tasks_is_told_with_both_folders(tmp_path):
    task = training_task(1)
    other = replace(training_task(2), id=task.id, seed=task.seed)
    for name, each in (("c1", task), ("c2", other)):
        write_batch(begin_collection(tmp_path / name), [lesson(each)])
    words = rf"c2/.*: {task.id} is another task here than in .*c1/.*--first"
    with pytest.raises(BadData, match=words):
        candidates_of([tmp_path / "c1", tmp_path / "c2"], {})
    assert len(candidates_of([tmp_path / "c1", tmp_path / "c1"], {})[0]) == 2


def test_one_id_for_two_objects_is_told_with_both_folders(tmp_path):
    task = training_task(1)
    for name in ("c1", "c2"):
        batch = write_batch(begin_collection(tmp_path / name), [lesson(task)])
    suite = suite_of([task])
    changed = {**suite.objects, "thing_find_1_1": (1.0, 3.0)}
    write_suite(batch.setting("agentic") / SUITE, replace(suite, objects=changed))
    words = r"c2/.*: thing_find_1_1 is another object here than in .*c1/"
    with pytest.raises(BadData, match=words):
        candidates_of([tmp_path / "c1", tmp_path / "c2"], {})


def test_a_folder_that_is_no_collection_or_empty(tmp_path):
    with pytest.raises(BadData, match=r"collection.json"):
        candidates_of([tmp_path], {})
    with pytest.raises(BadData, match="holds no whole batch. Let `probe collect` go on"):
        candidates_of([begin_collection(tmp_path)], {})
