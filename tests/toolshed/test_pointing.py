"""The tools with a model that points and tells, instead of the oracle."""

from __future__ import annotations

from dataclasses import replace

import pytest
import yaml

from probe.errors import ModelFailed
from probe.perception.choice import pointing
from probe.perception.oracle import Oracle
from probe.scene.setup import UR5_TABLE
from probe.toolshed.toolshed import Toolshed
from replies import Replies
from tabletops import PaintedStation

MUG = '{"point": [150, 150]}'


def tools(station, skills, *replies, pictures=True):
    model = Replies(replies)
    eyes = pointing(model)({}, dict)
    shed = Toolshed(
        station,
        eyes.detector,
        skills,
        UR5_TABLE,
        pictures=pictures,
        finder=eyes.finder,
        teller=eyes.teller,
    )
    return shed, model


def test_what_is_pointed_at_can_be_grasped(station, skills):
    shed, model = tools(station, skills, MUG)
    found = shed.call("find_object", {"description": "cup"})
    lines = yaml.safe_load(found.text)
    assert lines["object_id"] == "object_1" and set(lines) == {
        "object_id", "description", "point", "box",
    }  # fmt: skip
    assert "cup" not in found.text and "red" in lines["description"]
    assert found.picture is not None and (found.picture != shed.first_picture()).any()
    result = shed.call("grasp_and_remove", {"object_id": "object_1"})
    assert result.status == "done" and 41 not in [block.instance for block in station.blocks]
    again = shed.call("push", {"object_id": "object_1", "direction": "up", "distance_cm": 5})
    assert "out of date" in again.text
    assert len(model.asked) == 1


def test_other_things_that_move_leave_an_id_good(station, skills):
    shed, _ = tools(station, skills, MUG)
    shed.call("find_object", {"description": "cup"})
    station.blocks = [b for b in station.blocks if b.instance != 42]
    shed._view.show(station.observe(rgb=False))
    assert shed.call("grasp_and_remove", {"object_id": "object_1"}).status == "done"


def test_nothing_found_reads_as_with_the_oracle(station, skills, specs):
    shed, _ = tools(station, skills, '{"point": null}')
    oracle = Toolshed(station, Oracle(specs), skills, UR5_TABLE)
    question = {"description": "purple piano"}
    assert shed.call("find_object", question).text == oracle.call("find_object", question).text


def test_a_useless_reply_is_told_and_nothing_breaks(station, skills):
    shed, _ = tools(station, skills, "Left.", "Right.", MUG)
    result = shed.call("find_object", {"description": "cup"})
    assert result.status == "failed" and not result.ended
    assert "could not be used: there is no point in it" in result.text
    assert "find_object again" in result.text
    assert "object_1" in shed.call("find_object", {"description": "cup"}).text


def test_a_model_that_is_gone_is_no_fault_of_the_agents(station, skills):
    def gone(images, text):
        raise ModelFailed("no route")

    eyes = pointing(gone)({}, dict)
    shed = Toolshed(station, eyes.detector, skills, UR5_TABLE, finder=eyes.finder)
    with pytest.raises(ModelFailed, match="no route"):
        shed.call("find_object", {"description": "cup"})


def test_the_models_graph_reads_as_the_oracles(station, skills, specs):
    oracle = Toolshed(station, Oracle(specs), skills, UR5_TABLE).call("perceive_scene", {})
    shed, _ = tools(station, skills, oracle.text)
    told = shed.call("perceive_scene", {})
    graph = yaml.safe_load(oracle.text)
    for item in graph["objects"]:
        del item["object_id"]
    assert yaml.safe_load(told.text) == graph
    assert told.picture is not None
    assert "holds no object_ids; find_object gives them" in told.text
    assert "holds no object_ids" not in oracle.text


def test_a_graph_that_breaks_its_schema_is_told(station, skills):
    shed, _ = tools(station, skills, "A mug and a book.")
    result = shed.call("perceive_scene", {})
    assert result.status == "failed" and "perceive_scene again" in result.text


def test_texts_are_the_same_without_pictures_and_without_labels(station, skills):
    class Bare(PaintedStation):
        def observe(self, *, rgb):
            return replace(super().observe(rgb=rgb), labels=None, shares=None)

    texts = [
        tools(where, skills, MUG, pictures=pictures)[0]
        .call("find_object", {"description": "m"})
        .text
        for where, pictures in ((station, True), (station, False), (Bare(station.blocks), True))
    ]
    assert texts[0] == texts[1] == texts[2]
