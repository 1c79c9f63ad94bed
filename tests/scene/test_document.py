"""Scenes on disk."""

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from probe.errors import BadData
from probe.scene.document import SceneDocument, read_scene, write_scene
from probe.scene.scene import PlacedObject, Scene
from probe.types import Pose

number = st.floats(-1e12, 1e12)
turns = st.tuples(number, number, number, number).filter(lambda turn: math.hypot(*turn) > 1e-3)
units = turns.map(lambda turn: tuple(part / math.hypot(*turn) for part in turn))
poses = st.builds(Pose, st.tuples(number, number, number), units)
objects = st.builds(PlacedObject, st.integers(1, 40), st.text(min_size=1), poses)
several = st.lists(objects, max_size=5, unique_by=lambda placed: placed.instance)
scenes = st.builds(Scene, st.integers(0, 2**62), st.text(), several.map(tuple))

MUG = '{"instance":2,"object_id":"mug","position":[0,0,0],"wxyz":[1,0,0,0]}'


def _one(number: int = 1, position: str = "[0,0,0]", wxyz: str = "[1,0,0,0]") -> str:
    return (
        f'{{"version":1,"seed":3,"table":"oak","objects":[{{"instance":{number},'
        f'"object_id":"mug","position":{position},"wxyz":{wxyz}}}]}}'
    )


@given(scenes)
def test_every_bit_survives(scene):
    text = SceneDocument.of(scene).model_dump_json()
    assert SceneDocument.model_validate_json(text).scene() == scene


def test_reads_what_it_wrote(tmp_path):
    scene = Scene(3, "oak", (PlacedObject(1, "mug", Pose((0.1, 0.2, 0.3))),))
    write_scene(tmp_path / "scene.json", scene)
    assert read_scene(tmp_path / "scene.json") == scene


@pytest.mark.parametrize(
    ("content", "what"),
    [
        ("", "Invalid JSON"),
        ('{"version":1,"seed":3,"table":"oak","objects":[{"instance":1', "Invalid JSON"),
        ('{"version":2,"seed":3,"table":"oak","objects":[]}', "version"),
        (
            '{"version":1,"seed":3,"table":"oak","objects":[{"instance":1,"object_id":"mug",'
            '"position":[0,0,NaN],"wxyz":[1,0,0,0]}]}',
            "objects.0.position",
        ),
        ('{"version":1,"seed":-3,"table":"oak","objects":[]}', "seed: Input should be greater"),
        (
            _one(position="[0,0,1e13]"),
            "position.2: Input should be less than or equal to 1000000000000",
        ),
        (_one(wxyz="[0,0,0,0]"), "wxyz: Value error, a rotation is a quaternion of length 1"),
        (_one(wxyz="[2,0,0,0]"), "a quaternion of length 1, not 2"),
        (_one(number=2).replace("[{", "[" + MUG + ",{"), "instance 2 is there twice"),
    ],
)
def test_bad_files_are_named_with_place_and_remedy(tmp_path, content, what):
    path = tmp_path / "scene.json"
    path.write_text(content)
    with pytest.raises(BadData, match=what) as failure:
        read_scene(path)
    assert str(path) in str(failure.value)
    assert "probe scene" in str(failure.value)


def test_missing_file(tmp_path):
    with pytest.raises(BadData, match="No such file"):
        read_scene(tmp_path / "none.json")
