"""The teacher's episodes told without find_object, at a painted table and on the real one."""

from __future__ import annotations

import re
from dataclasses import replace

import pytest

from packed_teacher import packed_episodes
from painted_teacher import SIZE, taught
from probe.agents.phrases import silent
from probe.assets.library import open_library
from probe.episodes.play import set_table
from probe.render.renderer import Renderer
from probe.train.collect.teacher import speaker
from probe.train.dataset.augment.certain import NotCertain
from probe.train.dataset.augment.listed_ids import SayWithoutFinding, without_finding
from probe.train.dataset.augment.mirrored import mirrored
from probe.train.dataset.augment.rephrasing import rephrased


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
    listed = re.search(r"object_id: (object_\d+)\n  name: .?white ball", taught().steps[0].text)
    assert listed and f" {listed[1]}" in said[1] and "the object_" not in "".join(said)


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
    episodes = packed_episodes(tmp_path)
    longest = sorted(episodes, key=lambda it: -names(it[1]).count("find_object"))[:2]
    objects = open_library("procedural-2", None, cache)
    with Renderer() as renderer:
        for task, record in longest:
            tools, _ = set_table(task, objects, renderer, pictures=False)
            after = without_finding(rephrased(task, record, SayWithoutFinding(silent)))
            assert len(after.steps) < len(record.steps)
            for step in after.steps[:-1]:
                assert tools.call(step.call.name, step.call.values).text == step.text
