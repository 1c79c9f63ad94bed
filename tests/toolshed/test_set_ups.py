"""What the tools say and accept at tables with other set-ups; files that are examples of them."""

import json
from pathlib import Path

import pytest

from probe.errors import BadData
from probe.scene.setup import UR5_TABLE, picture_scale
from probe.scene.setup_file import read_setup
from probe.toolshed.parse import parse
from probe.toolshed.refusals import BadArguments
from probe.toolshed.tools import tool_schemas
from probe.transcripts.prompts import system_prompt
from probe.transcripts.tools import tools_for

EXAMPLES = Path(__file__).parents[2] / "examples" / "setups"


def told(setup, view="top"):
    scale = picture_scale(setup, setup.camera(view))
    return json.dumps([vars(tool) for tool in tool_schemas(scale)])


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("narrow-gripper", "The gripper opens 10.0 cm wide."),
        ("high-camera", "The picture is 70 cm wide."),
        ("basket-left", "The picture is 58 cm wide."),
        ("jaco", "The gripper opens 11.0 cm wide."),
    ],
)
def test_tools_say_the_sizes_of_their_set_up(name, said):
    assert said in told(read_setup(EXAMPLES / f"{name}.json"))


def test_a_picture_from_the_front_is_told_as_such():
    text = told(UR5_TABLE, "front")
    assert "is away from the camera" in text and "Across its middle" in text
    scale = picture_scale(UR5_TABLE, UR5_TABLE.camera("front"))
    assert "obliquely from the front" in system_prompt("direct", "pixels", scale)


def test_points_are_refused_beyond_the_edge_of_smaller_pictures(tmp_path):
    path = tmp_path / "small.json"
    path.write_text(json.dumps({"name": "small", "picture_px": 512}))
    small = read_setup(path)
    scale = picture_scale(small, small.camera())
    assert '"exclusiveMaximum": 512' in told(small)
    answer = {"choice": "A", "point": [600, 3]}
    assert parse("answer_question", answer)
    with pytest.raises(BadArguments, match="less than 512"):
        parse("answer_question", answer, 512)
    with pytest.raises(BadData, match="thousandths"):
        tools_for("0-1000", scale)
