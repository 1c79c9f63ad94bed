"""Set-ups on disk: what isn't said is as usual, what can't be is refused by its field."""

import json
from dataclasses import replace

import pytest

from probe.errors import BadData
from probe.scene.document import read_scene, write_scene
from probe.scene.scene import PlacedObject, Scene
from probe.scene.setup import ROOM_TABLE, UR5_TABLE, Basket, GripperSize, newest
from probe.scene.setup_file import SetupDocument, read_setup
from probe.types import Pose

OTHER = {
    "name": "other",
    "gripper": {"max_opening": 0.085},
    "top": {"height": 1.5, "width": 0.7},
    "basket": {"position": [-0.55, -0.5, 0.0]},
    "depth_noise": 0.0005,
}


def written(folder, **fields):
    path = folder / "setup.json"
    path.write_text(json.dumps(fields))
    return path


def test_only_what_differs_needs_to_be_said(tmp_path):
    found = read_setup(written(tmp_path, **OTHER))
    assert found.gripper == replace(UR5_TABLE.gripper, max_opening=0.085)
    assert found.basket.size == UR5_TABLE.basket.size
    assert found.view_size == 0.7
    assert found.mount == UR5_TABLE.mount
    assert read_setup(written(tmp_path, name="ur5")) == UR5_TABLE


@pytest.mark.parametrize(
    ("fields", "named"),
    [
        ({"gripper": {"max_opening": 0.3}}, "gripper.max_opening"),
        ({"gripper": {"width": 0.1}}, "gripper.width"),
        ({"basket": {"position": [0.3, 0.2, 0.0]}}, "basket"),
        ({"work_area": 0.6}, "work_area"),
        ({"table_size": [0.5, 0.5]}, "table_size"),
        ({"front": {"eye": [0.0, 0.9, 0.5]}}, "front"),
        ({"mount": {"wxyz": [1, 1, 0, 0]}}, "mount.wxyz"),
        ({"mount": {"parked": [0, 0]}}, "mount.parked"),
        ({"mount": {"arm": "panda"}}, "mount.arm"),
        ({"mount": {"arm": "jaco"}}, "mount"),
        ({"depth_noise": float("nan")}, "depth_noise"),
        ({"name": "ur5", "picture_px": 512}, "name"),
        ({"name": "Two Words"}, "name"),
    ],
)
def test_what_cannot_be_is_refused_by_its_field(tmp_path, fields, named):
    path = written(tmp_path, **{"name": "other", **fields})
    with pytest.raises(BadData, match=named) as refused:
        read_setup(path)
    assert str(path) in str(refused.value)


def test_a_scene_keeps_its_set_up_to_the_last_bit_and_the_usual_one_is_not_written(tmp_path):
    setup = replace(
        UR5_TABLE,
        name="odd",
        gripper=GripperSize(max_opening=0.1 / 3 + 0.06),
        basket=Basket((-0.55 - 1 / 300, -0.44, 0.0)),
    )
    scene = Scene(3, "oak", (PlacedObject(1, "mug", Pose()),), setup)
    path = tmp_path / "scene.json"
    write_scene(path, scene)
    assert read_scene(path) == scene
    write_scene(path, replace(scene, setup=UR5_TABLE))
    assert "setup" not in path.read_text()
    assert read_scene(path).setup == UR5_TABLE


def test_a_set_up_names_its_arm_only_where_it_is_another(tmp_path):
    parked = (0.0, 3.1, 5.5, 0.0, 2.3, 0.0)
    mount = {"arm": "jaco", "parked": parked}
    other = read_setup(written(tmp_path, name="other", mount=mount))
    assert (other.mount.arm, other.mount.parked) == ("jaco", parked)
    assert SetupDocument.of(other).setup() == other
    usual = replace(other, mount=UR5_TABLE.mount)
    kept = json.loads(SetupDocument.of(usual).model_dump_json())
    assert set(kept["mount"]) == {"position", "wxyz", "parked"}


def test_light_looks_and_renderer_are_kept_and_may_differ_in_the_usual_set_up(tmp_path):
    assert read_setup(written(tmp_path, name="ur5")).lighting == "ambient"
    other = replace(ROOM_TABLE, renderer="blender")
    assert SetupDocument.of(other).setup() == other
    path = tmp_path / "scene.json"
    write_scene(path, Scene(1, "oak_planks", (), other))
    assert read_scene(path).setup == other


def test_a_set_up_of_before_there_were_looks_keeps_its_bytes():
    said = SetupDocument.of(replace(UR5_TABLE, name="other")).model_dump()
    assert said.keys().isdisjoint({"lighting", "looks", "renderer"})


def test_new_scenes_have_the_rooms_light_unless_the_set_up_names_another():
    assert newest(UR5_TABLE) == ROOM_TABLE
    assert newest(replace(UR5_TABLE, lighting="cellar")).lighting == "cellar"
    assert newest(ROOM_TABLE, "ambient", 1) == UR5_TABLE
