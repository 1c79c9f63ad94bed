"""Each format on a box of known size, and on the true layouts."""

from __future__ import annotations

import json

import numpy as np
import pytest
import trimesh

from data_sets import bop_set, box, gso_folder, obj_folder
from glb_files import FILE_FROM_Z_UP, textured, write_glb
from probe.assets.importers.adding import find_sources
from probe.assets.importers.normalised import content_of, normalised
from probe.assets.importers.options import ImportOptions
from probe.assets.importers.source import NO_LICENCE
from probe.assets.pools.entry import LibraryEntry
from probe.errors import BadData
from probe.types import Pose

SIZE = (0.1, 0.06, 0.04)
SETS = [("gso", "gso_layout", 12), ("bop", "bop", 21)]


def _only(path, order):
    (source,) = find_sources(path, order)
    return normalised(source, order)


def _write(kind, folder):
    if kind == "gltf":
        folder.mkdir()
        write_glb(folder / "box.glb", textured(box()))
    elif kind == "obj":
        obj_folder(folder, box().apply_transform(FILE_FROM_Z_UP))
    elif kind == "gso":
        gso_folder(folder)
    else:
        bop_set(folder)
    return folder


@pytest.mark.parametrize("kind", ["gltf", "obj", "gso", "bop"])
def test_any_format_gives_the_same_box_lying_on_the_table(tmp_path, kind):
    mesh, entry = _only(_write(kind, tmp_path / "set"), ImportOptions(kind))
    assert mesh.extent == pytest.approx(SIZE, abs=1e-5)
    low, high = mesh.vertices.min(axis=0), mesh.vertices.max(axis=0)
    assert low[2] == pytest.approx(0, abs=1e-6)
    assert (low + high)[:2] == pytest.approx([0, 0], abs=1e-6)
    assert entry.size == pytest.approx(SIZE)
    assert entry.colours[0] == "red"
    assert not entry.hollow


@pytest.mark.parametrize(("unit", "metres"), [("cm", 0.01), ("mm", 0.001)])
def test_units_and_axes_of_an_obj_can_be_told(tmp_path, unit, metres):
    obj_folder(tmp_path / "set", box().apply_scale(1 / metres))
    mesh, entry = _only(tmp_path / "set", ImportOptions("obj", unit=metres, up="z"))
    assert mesh.extent == pytest.approx(SIZE, abs=1e-5)
    assert entry.unit == metres


def test_what_stands_askew_is_laid_down(tmp_path):
    turned = trimesh.creation.box(SIZE).apply_transform(
        trimesh.transformations.rotation_matrix(0.3, (1, 2, 0))
    )
    obj_folder(tmp_path / "set", turned)
    mesh, entry = _only(tmp_path / "set", ImportOptions("obj", up="z"))
    assert mesh.extent == pytest.approx(SIZE, abs=1e-5)
    # The entry tells how to get from the file to the object.
    pose = Pose(entry.shift, entry.turn_wxyz)
    low = pose.apply(np.asarray(turned.vertices)).min(axis=0)
    assert low == pytest.approx([-0.05, -0.03, 0.0], abs=1e-5)


def test_what_the_data_set_says_is_kept_and_the_rest_is_marked_as_a_guess(tmp_path):
    entry = _only(gso_folder(tmp_path / "Small_Box"), ImportOptions("gso"))[1]
    assert (entry.name, entry.category, entry.mass) == ("small box", "action figure", 0.25)
    assert entry.licence == "CC-BY-4.0"
    assert entry.source == "Google Scanned Objects, Small_Box"
    assert entry.provenance["mass"] == "source"
    obj_folder(tmp_path / "bare")
    bare = _only(tmp_path / "bare", ImportOptions("obj"))[1]
    assert bare.licence == NO_LICENCE
    assert bare.provenance["mass"] == "estimated"
    # No word tells what it is: 400 kg by cubic metre of hull.
    assert bare.mass == pytest.approx(400 * 0.1 * 0.06 * 0.04, abs=0.001)
    told = _only(tmp_path / "bare", ImportOptions("obj", licence="MIT", source="me"))[1]
    assert (told.licence, told.source) == ("MIT", "me")


def test_the_symmetries_of_a_model_come_along(tmp_path):
    half_turn = [-1, 0, 0, 600, 0, -1, 0, -400, 0, 0, 1, 0, 0, 0, 0, 1]
    continuous = [{"axis": [0, 0, 1], "offset": [300, -200, 0]}]
    folder = bop_set(
        tmp_path / "set", symmetries_discrete=[half_turn], symmetries_continuous=continuous
    )
    mesh, entry = _only(folder, ImportOptions("bop"))
    (matrix,) = entry.symmetries_discrete
    # The box stood at (300, -200) mm: about that vertical, half a turn leaves it as it is.
    corners = np.unique(np.round(mesh.vertices.astype(float), 5), axis=0)
    moved = corners @ np.reshape(matrix, (4, 4))[:3, :3].T + np.reshape(matrix, (4, 4))[:3, 3]
    for corner in moved:
        assert np.abs(corners - corner).max(axis=1).min() < 1e-4
    (axis,) = entry.symmetries_continuous
    assert axis.axis == pytest.approx([0, 0, 1], abs=1e-6)
    assert axis.offset[:2] == pytest.approx([0, 0], abs=1e-6)


def test_a_long_name_is_cut_so_that_it_still_says_what_the_thing_is(tmp_path):
    name = "BIA_Cordon_Bleu_White_Porcelain_Utensil_Holder_900028"
    entry = _only(gso_folder(tmp_path / name), ImportOptions("gso"))[1]
    assert entry.name == "bleu white porcelain utensil holder"
    assert len(entry.id) <= 44 and entry.id.startswith("own_bia_cordon")


def test_content_tells_files_and_orders_apart(tmp_path):
    order = ImportOptions("obj")
    (source,) = find_sources(obj_folder(tmp_path / "set").parent, order)
    first = content_of(source, order)
    assert content_of(source, order) == first
    assert content_of(source, ImportOptions("obj", unit=0.5)) != first
    (tmp_path / "set" / "texture.png").write_bytes(b"other")
    with pytest.raises(Exception, match="texture"):
        content_of(source, order)


def test_a_folder_without_objects_is_told(tmp_path):
    for path in (tmp_path, tmp_path / "none"):
        with pytest.raises(BadData, match=str(path)):
            find_sources(path, ImportOptions("gso"))


@pytest.mark.parametrize(
    ("kind", "folder", "count"), [("gso", "gso_layout", 12), ("bop", "bop", 21)]
)
def test_the_true_layouts_are_read_whole(assets, kind, folder, count):
    order = ImportOptions(kind)
    sources = find_sources(assets / folder, order)
    assert len(sources) == count
    for source in sources[::7]:
        mesh, entry = normalised(source, order)
        assert max(entry.size) < 0.3
        assert mesh.vertices[:, 2].min() == pytest.approx(0, abs=1e-6)
        assert len(mesh.surface.texture) >= 256


def test_entries_of_before_are_read_and_their_files_known_again(tmp_path):
    """An entry as it was written before axes and remarks were kept, and its content's hash."""
    obj_folder(tmp_path / "set")
    (source,) = find_sources(tmp_path / "set", ImportOptions("obj"))
    entry = normalised(source, ImportOptions("obj"))[1]
    old = entry.model_dump(mode="json", exclude={"up", "up_sure", "remarks"})
    back = LibraryEntry.model_validate_json(json.dumps(old | {"id": "own_model_ed1743"}))
    assert back.content == content_of(source, ImportOptions("obj"))
    assert (back.up, back.up_sure, back.remarks) == (None, True, ())
    # What the order was, in words, is part of the hash: its form must not change.
    assert (
        ImportOptions("obj").key
        == "Order(format='obj', unit=None, up=None, licence=None, source=None)"
    )
