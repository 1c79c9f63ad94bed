"""What is no object of its own is passed over and counted apart."""

import shutil

import numpy as np
import trimesh

from data_sets import box, obj_folder, obj_text
from glb_files import textured, write_glb
from probe.assets.importers.adding import ImportTarget, add, objects_at
from probe.assets.importers.checking import sifted_at
from probe.assets.importers.options import ImportOptions

OBJ = ImportOptions("obj")


def _ycb(root, name, size=(0.1, 0.06, 0.04)):
    """One of YCB's folders: two textured reconstructions, one without texture."""
    for kind, shrunk in (("google_16k", 1.0), ("tsdf", 0.99)):
        mesh = trimesh.creation.box(np.array(size) * shrunk)
        obj_folder(root / name / kind, mesh)
        (root / name / kind / "model.obj").rename(root / name / kind / "textured.obj")
    (root / name / "poisson").mkdir()
    (root / name / "poisson" / "nontextured.obj").write_text(obj_text(box(), "none.mtl"))


def test_ycb_s_reconstructions_are_one_object_the_best_of_them(tmp_path):
    _ycb(tmp_path, "003_apple")
    _ycb(tmp_path, "025_mug", (0.08, 0.08, 0.1))
    sources, passed = objects_at(tmp_path, OBJ)
    assert [source.label for source in sources] == [
        "003_apple/google_16k/textured.obj",
        "025_mug/google_16k/textured.obj",
    ]
    assert len(passed) == 4
    assert all("the same object as" in one.reason for one in passed)


def test_collision_meshes_and_pieces_are_no_objects(tmp_path):
    obj_folder(tmp_path / "cup" / "visual")
    for name in ("cup/visual/model_coll", "cup/collision/model", "cup/cup_vhacd_3"):
        path = tmp_path / f"{name}.obj"
        path.parent.mkdir(exist_ok=True)
        path.write_text(obj_text(box()))
    sources, passed = objects_at(tmp_path, OBJ)
    assert [source.label for source in sources] == ["cup/visual/model.obj"]
    assert len(passed) == 3 and {one.reason for one in passed} == {"a collision mesh, by its name"}


def test_numbered_models_in_one_folder_are_objects_each(tmp_path):
    obj_folder(tmp_path)
    for number in (1, 2, 3):
        mesh = box((0.1, 0.06, 0.02 + 0.01 * number))
        (tmp_path / f"model_{number}.obj").write_text(obj_text(mesh))
    (tmp_path / "model.obj").unlink()
    assert len(objects_at(tmp_path, OBJ)[0]) == 3


def test_copies_and_the_same_thing_in_two_formats_count_once(tmp_path):
    obj_folder(tmp_path / "a tin")
    shutil.copytree(tmp_path / "a tin", tmp_path / "copied tin")
    write_glb(tmp_path / "a tin" / "model.glb", textured(box()))
    candidates, passed = sifted_at(tmp_path)
    assert len(candidates) == 1
    assert sorted(one.reason.partition(" as ")[0] for one in passed) == [
        "the same files",
        "the same object",
    ]


def test_ids_are_readable_and_the_same_whatever_the_order(tmp_path):
    for folder, height in (("kitchen", 0.03), ("toys", 0.05)):
        obj_folder(tmp_path / "set" / folder / "apple", box((0.1, 0.06, height)))
    sources, _ = objects_at(tmp_path / "set", OBJ)
    ids = []
    for name, order in (("one", sources), ("other", sources[::-1])):
        target = ImportTarget(tmp_path / name, tmp_path / f"{name} cache")
        outcomes = add(order, OBJ, target, 1)
        ids.append({outcome.label: outcome.detail for outcome in outcomes})
    assert ids[0] == ids[1]
    assert ids[0] == {
        "kitchen/apple/model.obj": "own_apple",
        "toys/apple/model.obj": "own_apple_2",
    }
    again = add(sources, OBJ, ImportTarget(tmp_path / "one", tmp_path / "one cache"), 1)
    assert [outcome.status for outcome in again] == ["skipped", "skipped"]
