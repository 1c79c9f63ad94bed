"""Which way is up in a file that doesn't say, and which unit."""

import numpy as np
import pytest
import trimesh

from data_sets import box, obj_folder
from glb_files import FILE_FROM_Z_UP
from probe.assets.gltf.glb import read_gltf
from probe.assets.importers.adding import find_sources
from probe.assets.importers.checking import sifted_at, verdict_of
from probe.assets.importers.normalised import normalised
from probe.assets.importers.options import ImportOptions
from probe.assets.importers.reposing import reposed
from probe.assets.importers.upright import likely_up
from probe.errors import BadMesh

TURN = FILE_FROM_Z_UP[:3, :3]


def _cone(standing: bool):
    cone = trimesh.creation.cone(0.04, 0.1, sections=32)
    return np.asarray(cone.vertices) - ([0, 0, 0] if standing else [0, 0, 0.04])


def test_what_stands_on_zero_along_one_axis_has_that_one_up():
    for points, up in ((_cone(True), "z"), (_cone(True) @ TURN.T, "y")):
        for fallback in ("y", "z"):
            reading = likely_up(points, fallback)
            assert (reading.up, reading.sure) == (up, True)


def test_what_stands_one_way_and_falls_the_other_is_no_riddle_either():
    assert likely_up(_cone(False), "y") == likely_up(_cone(False), "z")
    assert likely_up(_cone(False), "y").up == "z"


def test_a_box_about_its_middle_may_be_read_both_ways_and_that_is_said(tmp_path):
    middle = trimesh.creation.box((0.1, 0.06, 0.04))
    assert not likely_up(np.asarray(middle.vertices), "y").sure
    obj_folder(tmp_path / "tin", middle)
    (candidate,), _ = sifted_at(tmp_path)
    verdict = verdict_of(candidate)
    assert verdict.refusal is None
    assert "up axis not certain: y taken, z is as likely" in verdict.remarks[0]
    (told,), _ = sifted_at(tmp_path, up="z")
    assert verdict_of(told).remarks == ()


def test_the_other_way_up_is_as_if_it_had_been_said_at_once(tmp_path):
    obj_folder(tmp_path / "tin", trimesh.creation.box((0.1, 0.06, 0.04)))
    (source,) = find_sources(tmp_path, ImportOptions("obj"))
    mesh, entry = normalised(source, ImportOptions("obj"))
    laid, changed = reposed(mesh, entry, "z")
    wanted, told = normalised(source, ImportOptions("obj", up="z"))
    assert laid.extent == pytest.approx(wanted.extent, abs=1e-6)
    assert changed.size == told.size and changed.size != entry.size
    assert changed.turn_wxyz == pytest.approx(told.turn_wxyz, abs=1e-6)
    assert changed.shift == pytest.approx(told.shift, abs=1e-6)
    assert (changed.up, changed.up_sure) == ("z", True)
    assert laid.vertices[:, 2].min() == pytest.approx(0, abs=1e-7)


@pytest.mark.parametrize(
    ("scale", "unit", "said"),
    [
        (1000, None, "60 m.*millimetres taken for metres.*--unit mm"),
        (100, None, "6 m.*centimetres taken for metres.*--unit cm"),
        (1, 0.001, "0.06 mm.*metres taken for millimetres.*--unit m "),
    ],
)
def test_an_absurd_size_names_the_unit_that_would_fit(tmp_path, scale, unit, said):
    obj_folder(tmp_path / "apple", box((0.06, 0.06, 0.06)).apply_scale(scale))
    (source,) = find_sources(tmp_path, ImportOptions("obj"))
    with pytest.raises(BadMesh, match=said):
        normalised(source, ImportOptions("obj", unit=unit))


def test_scans_are_read_the_right_way_up(assets):
    for name in ("ycb_025_mug", "gso_lion", "ph_teacup", "ycb_006_mustard_bottle", "pum_blue_cup"):
        part = read_gltf(assets / "scans" / f"{name}.glb")
        points = np.asarray(part.vertices)[np.unique(part.faces)]
        for turned, up in ((points, "y"), (points @ TURN, "z")):
            reading = likely_up(turned, "y")
            assert (reading.up, reading.sure) == (up, True), name
