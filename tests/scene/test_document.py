"""Scenes on disk."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from probe.errors import BadData
from probe.scene.document import SceneDocument, read_scene, write_scene
from probe.scene.scene import PlacedObject, Scene
from probe.types import Pose

number = st.floats(allow_nan=False, allow_infinity=False)
poses = st.builds(
    Pose, st.tuples(number, number, number), st.tuples(number, number, number, number)
)
objects = st.builds(PlacedObject, st.integers(1, 40), st.text(min_size=1), poses)
scenes = st.builds(
    Scene, st.integers(0, 2**62), st.text(), st.lists(objects, max_size=5).map(tuple)
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
