"""`probe select` on a collection into which tasks of evaluation were slipped."""

from __future__ import annotations

from dataclasses import replace

import pytest

from lessons import FIRST_SEED, begin_collection, lesson, suite_of, training_task, write_batch
from probe.assets.pools.split import Split, write_split
from probe.cli.select import select
from probe.errors import BadData
from probe.tasks.suite_file import write_suite
from probe.tasks.task import Certificate
from probe.train.choose.chosen import read_selection
from run_folders import DEMO

GOOD = [training_task(n) for n in range(4)]
UNOFFERED = Certificate({}, {}, ())


def leaks(tmp_path):
    """A task of a suite; its scene under a training seed; a seed of a suite; an object's."""
    own = replace(training_task(50), seed=FIRST_SEED + 777)
    write_suite(tmp_path / "secret.json", suite_of([own], "secret"))
    return {
        "task": DEMO.tasks[0],
        "scene": replace(DEMO.tasks[1], id="x-1", seed=FIRST_SEED + 1),
        "seed": replace(training_task(60), id="x-2", seed=own.seed),
        "object": replace(training_task(61), certificate=UNOFFERED),
    }


def test_planted_leaks_are_refused_and_told(tmp_path, capsys):
    planted = leaks(tmp_path)
    good = [replace(task, certificate=UNOFFERED) for task in GOOD]
    lessons = [lesson(task) for task in [*good, *planted.values()]]
    write_batch(begin_collection(tmp_path / "c1"), lessons)
    ids = [placed.object_id for task in good for placed in task.scene.objects]
    parts = {planted["object"].scene.objects[1].object_id: "evaluation"}
    parts |= dict.fromkeys(
        [*ids, *(o.object_id for o in planted["object"].scene.objects[::2])], "train"
    )
    write_split(tmp_path / "split.json", Split.model_validate({"parts": parts}))
    select(
        (tmp_path / "c1",),
        tmp_path / "s1",
        against=(str(tmp_path / "secret.json"),),
        split=tmp_path / "split.json",
        near=False,
    )
    chosen = read_selection(tmp_path / "s1")
    assert sorted(task.id for task, _ in chosen.episodes) == sorted(task.id for task in good)
    refused = {it.task: it.leak for it in chosen.document.refused}
    assert refused == {task.id: leak for leak, task in planted.items()}
    assert "demo" in chosen.document.suites and "secret" in chosen.document.suites
    assert "4 tasks belong to evaluation and were refused" in capsys.readouterr().out


def test_a_collection_of_nothing_but_evaluation_is_refused(tmp_path):
    write_batch(begin_collection(tmp_path / "c1"), [lesson(task) for task in DEMO.tasks[:2]])
    with pytest.raises(BadData, match="holds no episode to learn from. Collect more"):
        select((tmp_path / "c1",), tmp_path / "s1", near=False)
    assert not (tmp_path / "s1").exists()


def test_answers_without_tools_alone_need_a_share_of_all(tmp_path):
    lessons = [lesson(task, setting="direct") for task in GOOD]
    write_batch(begin_collection(tmp_path / "c1"), lessons)
    with pytest.raises(BadData, match="holds no episode to learn from. Say --direct-share 1"):
        select((tmp_path / "c1",), tmp_path / "s1", near=False)
    select((tmp_path / "c1",), tmp_path / "s1", near=False, direct_share=1.0)
    assert len(read_selection(tmp_path / "s1").episodes) == len(GOOD)


def test_a_folder_that_is_there_is_told_before_anything_is_read(tmp_path):
    (tmp_path / "s1").mkdir()
    with pytest.raises(BadData, match="s1: is there already. Choose a new folder"):
        select((tmp_path / "nowhere",), tmp_path / "s1")


def test_things_that_are_not_here_are_told_and_not_left_uncompared(tmp_path):
    write_batch(begin_collection(tmp_path / "c1"), [lesson(GOOD[0])])
    words = r"thing_find_0_1: appears \(and 2 more\).*PROBE_ASSETS.*--no-near"
    with pytest.raises(BadData, match=words):
        select((tmp_path / "c1",), tmp_path / "s1")
