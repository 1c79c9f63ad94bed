"""The tools on rendered frames: what lies out of sight leaves no trace in words or pixels."""

import pytest
import yaml

from boxes import box_library, standing, station_at
from probe.perception.oracle import Oracle
from probe.render.renderer import Renderer
from probe.scene.setup import UR5_TABLE
from probe.toolshed.toolshed import Toolshed
from tabletops import Obedient

LIBRARY = box_library(
    red_lid=(0.12, 0.12, 0.02, 190, 40, 40),
    blue_block=(0.06, 0.05, 0.04, 40, 80, 180),
    white_cube=(0.03, 0.03, 0.03, 235, 235, 235),
    black_slab=(0.05, 0.04, 0.02, 30, 30, 30),
    green_card=(0.2, 0.05, 0.01, 50, 130, 60),
)
SEEN = [("blue_block", 0.1, 0.1, 0.0), ("green_card", 0.12, -0.04, 0.0)]
CALLS = [
    ("perceive_scene", {}),
    ("find_object", {"description": "the thing at (424, 512)"}),
    ("find_object", {"description": "white cube"}),
    ("find_object", {"description": "black slab"}),
]


@pytest.fixture(scope="module")
def renderer():
    with Renderer() as it:
        yield it


def told(renderer, *spots):
    scene = standing(LIBRARY, *spots)
    station = station_at(scene, LIBRARY, renderer)
    specs = {o.instance: LIBRARY[o.object_id] for o in scene.objects}
    shed = Toolshed(station, Oracle(specs), Obedient(), UR5_TABLE)
    results = [shed.call(*call) for call in CALLS]
    return [(r.text, r.picture.tobytes()) for r in results if r.picture is not None]


def test_twins_under_a_lid_are_told_alike(renderer):
    lid = ("red_lid", -0.05, 0.0, 0.04)
    cube = told(renderer, lid, *SEEN, ("white_cube", -0.05, 0.0, 0.0))
    slab = told(renderer, lid, *SEEN, ("black_slab", -0.05, 0.0, 0.0))
    assert len(cube) == len(CALLS)
    assert cube == slab
    graph = yaml.safe_load(cube[0][0])
    assert [o["name"] for o in graph["objects"]] == ["blue block", "red lid", "green card"]
    assert not any(word in text for text, _ in cube for word in ("secret", "987654321", "_77"))


def test_heights_tell_what_is_on_what(renderer):
    block_on_card = [("green_card", 0.0, 0.0, 0.0), ("white_cube", 0.0, 0.0, 0.01)]
    graph = yaml.safe_load(told(renderer, *block_on_card)[0][0])
    names = [o["name"] for o in graph["objects"]]
    cube, card = names.index("white cube") + 1, names.index("green card") + 1
    assert f"{cube} on {card}" in graph["relations"]
