"""What an agent must not be able to learn from the tools."""

import numpy as np
import pytest

from probe.perception.oracle import Oracle
from probe.scene.setup import UR5_TABLE
from probe.toolshed.toolshed import Toolshed
from tabletops import Block, PaintedStation, spec

HIDDEN = (605, 455, 640, 500)
CALLS = [
    ("perceive_scene", {}),
    ("find_object", {"description": "white ball"}),
    ("find_object", {"description": "yellow duck"}),
    ("find_object", {"description": "the thing at (620, 470)"}),
    ("find_object", {"description": "duck 917"}),
    ("push", {"object_id": "object_9", "direction": "up", "distance_cm": 5}),
    ("grasp_and_remove", {"object_id": "object_1"}),
]


def told(blocks, specs, skills):
    """All texts and pictures of the calls, on a table of these blocks."""
    shed = Toolshed(PaintedStation(blocks), Oracle(specs), skills, UR5_TABLE)
    results = [shed.call(*call) for call in CALLS]
    return [(r.text, None if r.picture is None else r.picture.tobytes()) for r in results]


@pytest.fixture
def blocks(station):
    return list(station.blocks)


def test_twins_that_render_alike_are_told_alike(blocks, specs, skills):
    calls = CALLS[:-1]
    duck = [*blocks, Block(917, HIDDEN, height=0.01)]
    swan = [*blocks, Block(55, HIDDEN, height=0.01)]
    specs = specs | {917: spec("yellow duck", "yellow"), 55: spec("white swan", "white")}
    outputs = [told(table, specs, skills)[: len(calls)] for table in (duck, swan, blocks)]
    assert outputs[0] == outputs[1] == outputs[2]


def test_no_id_instance_number_or_unseen_thing_is_told(blocks, specs, skills):
    blocks = [*blocks, Block(917, HIDDEN, height=0.01)]
    specs = specs | {917: spec("yellow duck", "yellow", description="A rubber bird.")}
    shed = Toolshed(PaintedStation(blocks), Oracle(specs), skills, UR5_TABLE)
    texts = "\n".join(shed.call(*call).text for call in CALLS[:-1]).replace("'duck 917'", "")
    for secret in ("secret", "_77", "917", "duck", "rubber", "teapot", "0.1234"):
        assert secret not in texts


def test_removal_tells_the_handle_never_a_name(blocks, specs, skills):
    text, _ = told(blocks, specs, skills)[-1]
    assert "object_1" in text
    assert not any(word in text for word in ("white", "ball", "round"))


def test_permuted_instance_numbers_change_nothing(blocks, specs, skills):
    swap = {41: 43, 42: 44, 43: 42, 44: 41}
    swapped = [
        Block(swap[b.instance], b.box, b.height, b.colour, b.share) for b in reversed(blocks)
    ]
    assert told(blocks, specs, skills) == told(
        swapped, {swap[n]: s for n, s in specs.items()}, skills
    )


def test_pictures_carry_nothing_but_pixels(shed):
    picture = shed.call("perceive_scene", {}).picture
    assert type(picture) is np.ndarray and picture.dtype == np.uint8
