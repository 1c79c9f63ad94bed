"""The teacher's episodes told without find_object, at a painted table and on the real one."""

from __future__ import annotations

import tarfile
from dataclasses import replace
from pathlib import Path

import pytest

from painted_teacher import SIZE, taught
from probe.agents.phrases import silent
from probe.assets.library import open_library
from probe.episodes.files import read_records
from probe.episodes.folder import RECORDS, SUITE
from probe.episodes.play import set_table
from probe.render.renderer import Renderer
from probe.tasks.suite_file import read_suite
from probe.train.collect.batches import batches
from probe.train.collect.teacher import speaker
from probe.train.dataset.augment.certain import NotCertain
from probe.train.dataset.augment.listed_ids import SayWithoutFinding, without_finding
from probe.train.dataset.augment.mirrored import mirrored
from probe.train.dataset.augment.rephrasing import rephrased

PACKED = Path(__file__).parents[4] / "runs/data/teacher.tar.xz"


def told(task, record):
    return without_finding(rephrased(task, record, SayWithoutFinding(speaker(task, record.run))))


def names(record):
    return [step.call.name for step in record.steps]


def test_a_manipulation_takes_its_object_id_from_the_list():
    before = taught()
    after = told(SIZE, before)
    assert "find_object" in names(before)
    assert names(after) == [name for name in names(before) if name != "find_object"]
    assert after.participation and len(after.participation.replies) == len(after.steps)
    grasp = next(step for step in after.steps if step.call.name == "grasp_and_remove")
    assert grasp.call.values["object_id"] in after.steps[0].text
    assert [step.text for step in after.steps] == [
        step.text for step in before.steps if step.call.name != "find_object"
    ]


def test_its_words_speak_of_no_search():
    said = [step.call.words for step in told(SIZE, taught()).steps]
    for word in ("find", "Found", "locate", "outline", "right place", "its id"):
        assert not [words for words in said if word in words]
    assert "white ball" in said[1]


def test_mirrored_it_stays_without_find_object():
    said = rephrased(SIZE, taught(), SayWithoutFinding(speaker(SIZE, 0)))
    assert names(without_finding(mirrored(SIZE, said))) == names(told(SIZE, taught()))


def test_nothing_is_guessed():
    record = taught()
    search = next(i for i, step in enumerate(record.steps) if step.call.name == "find_object")
    grasp = record.steps[search + 1]
    assert record.participation
    replies = record.participation.replies[: search + 1]
    seat = replace(record.participation, replies=replies)
    with pytest.raises(NotCertain, match="nothing is done with what find_object found"):
        without_finding(replace(record, steps=record.steps[: search + 1], participation=seat))
    with pytest.raises(NotCertain, match="several calls at once, or none"):
        without_finding(replace(record, participation=seat))
    other = replace(grasp, call=replace(grasp.call, arguments='{"object_id": "object_77"}'))
    steps = (*record.steps[: search + 1], other, *record.steps[search + 2 :])
    with pytest.raises(NotCertain, match="gave an object_id that no list has"):
        without_finding(replace(record, steps=steps))


@pytest.mark.slow  # Two tables with physics.
def test_the_tools_reply_so_without_find_object(tmp_path, cache):
    with tarfile.open(PACKED) as archive:
        archive.extractall(tmp_path, filter="data")
    batch = batches(tmp_path / "collected")[0]
    tasks = {task.id: task for task in read_suite(batch.folder / SUITE).tasks}
    records = read_records(batch.setting("agentic") / RECORDS)
    longest = sorted(records, key=lambda record: -names(record).count("find_object"))[:2]
    objects = open_library("procedural-2", None, cache)
    with Renderer() as renderer:
        for record in longest:
            task = tasks[record.task]
            tools, _ = set_table(task, objects, renderer, pictures=False)
            after = without_finding(rephrased(task, record, SayWithoutFinding(silent)))
            assert len(after.steps) < len(record.steps)
            for step in after.steps[:-1]:
                assert tools.call(step.call.name, step.call.values).text == step.text
