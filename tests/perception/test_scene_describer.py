import contextlib

import pytest
import yaml
from hypothesis import given, settings
from hypothesis import strategies as st

from probe.asking import UnusableReply
from probe.perception.points import Convention
from probe.perception.scene_describer import ModelSceneDescriber, read_graph
from probe.perception.scene_graph import Relation
from replies import Replies
from tabletops import paint

GOOD = """objects:
- number: 1
  name: red mug
  description: "A red mug:
    it lies on its side."
  point: [500, 600]
  box: [450, 550, 560, 660]
- number: 2
  description: Something flat
  point: [100, 50]
  box: [60, 20, 140, 90]
relations:
- 1 right_of 2
- [2, above, 1]
cluttered: [middle centre]
clear:
"""


def read(reply, convention: Convention = "pixels"):
    return read_graph(reply, convention, 1024, 1024)


@pytest.mark.parametrize("form", ["{}", "Here it is:\n```yaml\n{}```\nDone.", "```\n{}\n```"])
def test_a_graph_is_sorted_from_the_top_and_its_relations_follow(form):
    graph = read(form.format(GOOD))
    assert [entry.words.name for entry in graph.entries] == [None, "red mug"]
    assert graph.entries[1].words.description == "A red mug: it lies on its side."
    assert graph.entries[1].point_px == (500, 600)
    assert graph.entries[1].box_px == (450, 550, 560, 660)
    assert graph.relations == (Relation(0, "above", 1), Relation(1, "right_of", 0))
    assert graph.cluttered == ("middle centre",) and graph.clear == ()


def test_points_and_boxes_come_in_the_models_convention():
    entry = read(GOOD, "yx1000").entries[-1]
    assert entry.point_px == (int(600 * 1.024), int(500 * 1.024))
    left, top, right, bottom = entry.box_px
    assert (left, top) == (int(550 * 1.024), int(450 * 1.024))
    assert (right, bottom) == (int(660 * 1.024), int(560 * 1.024))


def test_an_empty_table():
    graph = read("objects: []")
    assert graph.entries == () and graph.relations == ()


def broken(**changes):
    value = yaml.safe_load(GOOD)
    for key, change in changes.items():
        value[key] = change
    return yaml.safe_dump(value)


@pytest.mark.parametrize(
    ("reply", "reason"),
    [
        ("There is a mug.", "the YAML"),
        ("", "the YAML"),
        ("objects: [", "isn't YAML"),
        ("objects: " + "[" * 3000, "isn't YAML"),
        ("a: 2024-99-99", "YAML"),
        (broken(objects=[{"number": 1}]), "objects.0.description"),
        (broken(objects=[{"number": 1, "description": "x", "point": [1, 2, 3], "box": [0] * 4}]),
         "objects.0.point"),
        (broken(objects=[{"number": 1, "description": "x", "point": [float("nan"), 2],
                          "box": [0] * 4}]), "objects.0.point"),
        (GOOD.replace("[500, 600]", "[5000, 600]"), "object 1: .*outside the picture"),
        (broken(relations=["1 inside 2"]), "relations.0.1"),
        (broken(relations=["1 above 7"]), "'1 above 7' is between no two objects"),
        (broken(relations=["1 above 1"]), "between no two objects"),
        (GOOD.replace("number: 2", "number: 1"), "same number"),
        (broken(cluttered=["everywhere"]), "cluttered.0"),
    ],
)  # fmt: skip
def test_what_is_wrong_is_named(reply, reason):
    with pytest.raises(UnusableReply, match=reason):
        read(reply)


@settings(deadline=None)
@given(st.text(max_size=300))
def test_any_text_is_a_graph_or_an_unusable_reply(reply):
    with contextlib.suppress(UnusableReply):
        read(reply)


def test_one_reply_may_be_mended_and_no_more():
    frame = paint([])
    model = Replies(["objects: 3", GOOD])
    assert len(ModelSceneDescriber(model).tell(frame).entries) == 2
    assert "objects: Input should be a valid list" in model.asked[1][1]
    assert model.asked[0][0][0] is frame.rgb
    model = Replies(["objects: 3", "objects: 4", GOOD])
    with pytest.raises(UnusableReply, match="objects"):
        ModelSceneDescriber(model).tell(frame)
    assert len(model.asked) == 2


def test_the_question_says_how_to_write_points():
    model = Replies([GOOD])
    ModelSceneDescriber(model, "yx1000").tell(paint([]))
    assert "[y, x], each from 0 to 1000" in model.asked[0][1]
