from __future__ import annotations

import pytest

from lessons import begin_collection, lesson, training_task, write_batch
from probe.errors import BadData
from probe.train.batches import GRADES, batches, harvest
from probe.train.gathering import candidates_of

LESSONS = [
    lesson(training_task(1), arm="direct", right=False),
    lesson(training_task(1)),
    lesson(training_task(2), arm="direct"),
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
    so_far = harvest(batches(tmp_path))
    assert (so_far.tasks, so_far.successes) == ({"find": 2, "count": 1}, {"find": 2})
    assert (so_far.episodes, so_far.cost) == (4, 1.0)
    assert (so_far.right, so_far.played) == (
        {"agentic": 1, "direct": 1}, {"agentic": 2, "direct": 2}
    )  # fmt: skip
    assert so_far.last == {"find": 2_000_002, "count": 2_000_003}


def test_an_unfinished_batch_is_left_out(tmp_path):
    write_batch(begin_collection(tmp_path), LESSONS[:1])
    (write_batch(tmp_path, LESSONS[1:], "0of1-00001").folder / GRADES).unlink()
    found, unfinished = candidates_of([tmp_path], {})
    assert len(found) == 1 and unfinished == 1
    assert harvest(batches(tmp_path)).episodes == 1


def test_a_record_that_is_cut_off_is_named(tmp_path):
    batch = write_batch(begin_collection(tmp_path), LESSONS)
    path = batch.arm("agentic") / "records.jsonl"
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


def test_a_folder_that_is_no_collection_or_empty(tmp_path):
    with pytest.raises(BadData, match=r"collection.json"):
        candidates_of([tmp_path], {})
    with pytest.raises(BadData, match="holds no whole batch. Let `probe collect` go on"):
        candidates_of([begin_collection(tmp_path)], {})
