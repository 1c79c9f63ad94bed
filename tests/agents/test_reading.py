import pytest

from probe.agents.reading import ShortList, read_graph, read_handle, read_handles
from probe.perception.oracle import Oracle
from probe.scene.setup import UR5_TABLE
from probe.toolshed.toolshed import TURNS, Toolshed
from tabletops import Block, Obedient, PaintedStation, spec

SPECS = {1: spec("red mug"), 2: spec("red mug"), 3: spec("blue book", "blue")}
BLOCKS = [
    Block(1, (100, 100, 219, 219)),
    Block(2, (400, 100, 519, 219)),
    Block(3, (100, 500, 299, 699), colour=(40, 85, 170)),
]


def reply(tool, **arguments):
    shed = Toolshed(PaintedStation(BLOCKS), Oracle(SPECS), Obedient(), UR5_TABLE)
    return shed.call(tool, arguments).text


def test_every_kind_of_reply_tells_its_ids():
    mugs = {"object_1": "red mug", "object_2": "red mug"}
    assert read_handles(reply("perceive_scene")) == mugs | {"object_3": "blue book"}
    assert read_handles(reply("find_object", description="mug")) == mugs
    assert read_handles(reply("find_object", description="green mug")) == mugs
    assert read_handles(reply("find_object", description="zeppelin")) == {}
    assert read_handles("Done: object_1 was lifted.") == read_handles(": [") == {}


def test_a_list_holds_the_ids_and_a_failed_search_no_single_one():
    graph = read_graph(reply("perceive_scene"))
    assert [seen.object_id for seen in graph.objects] == ["object_1", "object_2", "object_3"]
    assert read_handle(reply("find_object", description="green mug")) is None


def test_what_is_no_list_is_an_empty_graph():
    done = (
        "Done: object_1 was lifted and dropped into the basket. Also moved: red mug by about 5 cm."
    )
    assert read_graph(done).objects == ()
    assert read_graph("There is no object_id object_9.").objects == ()


@pytest.mark.parametrize(
    ("tool", "arguments"), [("perceive_scene", {}), ("find_object", {"description": "mug"})]
)
def test_the_last_reply_is_read_like_any_other(tool, arguments):
    shed = Toolshed(PaintedStation(BLOCKS), Oracle(SPECS), Obedient(), UR5_TABLE)
    for _ in range(TURNS - 1):
        shed.call("perceive_scene", {})
    last = shed.call(tool, arguments)
    assert last.ended and "last turn" in last.text
    assert read_graph(last.text) == read_graph(reply(tool, **arguments))
    assert read_handles(last.text) == read_handles(reply(tool, **arguments))


@pytest.mark.parametrize(
    "text",
    [
        "# All that shows: object_id, what it is.\n- object_1 red mug [159, 159]",
        "# Changed since the last list:\nout of date: object_1",
        "# Nothing has changed since the last list.",
        "# Nothing shows.",
    ],
)
def test_a_list_in_short_is_no_list_without_things(text):
    with pytest.raises(ShortList, match="Read the whole list instead"):
        read_graph(text)
