"""The one picture beside a mesh stands in where its material file doesn't name it."""

import pytest

from data_sets import MTL, box, obj_folder, obj_text, picture
from probe.assets.importers.adding import find_sources
from probe.assets.importers.normalised import content_of, normalised
from probe.assets.importers.options import ImportOptions
from probe.errors import BadMesh

OBJ = ImportOptions("obj", up="z")


def _only(path, order=OBJ):
    (source,) = find_sources(path, order)
    content_of(source, order)
    return normalised(source, order)


def _no_library(folder):
    (folder / "model.mtl").unlink()


def _other_name(folder):
    (folder / "model.mtl").write_text(MTL.replace("texture", "texture_0"))


def _no_line(folder):
    path = folder / "model.obj"
    path.write_text(path.read_text().replace("mtllib model.mtl\n", "").replace("usemtl skin\n", ""))


@pytest.mark.parametrize("spoil", [_no_library, _other_name, _no_line])
def test_the_only_picture_is_used_and_said(tmp_path, spoil):
    obj_folder(tmp_path / "tin")
    spoil(tmp_path / "tin")
    mesh, entry = _only(tmp_path)
    assert tuple(mesh.surface.texture[0, 0]) == (200, 30, 30)
    assert mesh.extent == pytest.approx((0.1, 0.06, 0.04), abs=1e-5)
    (remark,) = entry.remarks
    assert "texture.png, the only picture beside it, is used" in remark


def test_maps_of_other_things_than_colour_dont_count(tmp_path):
    obj_folder(tmp_path / "tin", mtl=MTL.replace("texture", "none"))
    for name in ("tin_normal.png", "roughness.png", "thumbnail.jpg"):
        picture(tmp_path / "tin" / name, (128, 128, 255))
    assert _only(tmp_path)[1].colours == ("red",)


def test_of_two_pictures_neither_is_taken(tmp_path):
    obj_folder(tmp_path / "tin", mtl=MTL.replace("texture", "none"))
    picture(tmp_path / "tin" / "label.png")
    with pytest.raises(BadMesh, match=r"label\.png, texture\.png it means can't be told.*map_Kd"):
        _only(tmp_path)


def test_a_picture_behind_a_link_out_of_the_folder_is_not_taken(tmp_path):
    obj_folder(tmp_path / "tin", mtl=MTL.replace("texture", "none"))
    (tmp_path / "tin" / "texture.png").rename(tmp_path / "elsewhere.png")
    (tmp_path / "tin" / "texture.png").symlink_to(tmp_path / "elsewhere.png")
    with pytest.raises(BadMesh, match=r"'none\.png', which isn't there"):
        _only(tmp_path)


@pytest.mark.parametrize("order", [ImportOptions("gso"), ImportOptions("obj")])
def test_google_s_layout_without_its_model_sdf(tmp_path, order):
    home = tmp_path / "Red_Tin_900028"
    (home / "meshes").mkdir(parents=True)
    (home / "meshes" / "model.obj").write_text(obj_text(box(), "model.mtl"))
    picture(home / "materials" / "textures" / "texture.png")
    _, entry = _only(tmp_path, order)
    assert (entry.name, entry.id, entry.category) == ("red tin", "own_red_tin", "tin")
    # Simulators' z points up, without being asked for.
    assert (entry.up, entry.up_sure) == ("z", True)
    assert entry.size == pytest.approx((0.1, 0.06, 0.04))
