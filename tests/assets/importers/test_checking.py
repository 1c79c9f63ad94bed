from __future__ import annotations

import numpy as np
import pytest
import trimesh

from data_sets import bop_set, box, gso_folder, obj_folder
from glb_files import textured, write_glb
from probe.assets.importers.checking import (
    Catalogued,
    candidates_at,
    scan_candidates,
    verdict_of,
)
from probe.errors import BadData


def test_everything_in_a_folder_is_found_once_whatever_its_format(tmp_path):
    gso_folder(tmp_path / "gazebo" / "Box")
    models = bop_set(tmp_path / "bop") / "toy" / "models"
    (models / "obj_000002.ply").write_bytes((models / "obj_000001.ply").read_bytes())
    obj_folder(tmp_path / "obj")
    write_glb(tmp_path / "x.glb", textured(box()))
    labels = sorted(candidate.label for candidate in candidates_at(tmp_path))
    assert labels == [
        "bop/toy/models/obj_000001.ply",
        "bop/toy/models/obj_000002.ply",
        "gazebo/Box",
        "obj/model.obj",
        "x.glb",
    ]


def test_nothing_to_check_is_told(tmp_path):
    for path in (tmp_path, tmp_path / "none"):
        with pytest.raises(BadData, match="no objects"):
            candidates_at(path)


def test_a_good_object_and_a_bad_one(tmp_path):
    write_glb(tmp_path / "brick.glb", textured(box()))
    write_glb(tmp_path / "cube.glb", textured(trimesh.creation.box((0.2, 0.2, 0.2))))
    verdicts = {c.label: verdict_of(c) for c in candidates_at(tmp_path)}
    assert verdicts["brick.glb"].refusal is None
    assert verdicts["brick.glb"].pieces == 1
    assert "can't be held" in (verdicts["cube.glb"].refusal or "")


def test_a_catalogued_object_is_checked_as_it_is_used(tmp_path):
    plank = write_glb(tmp_path / "plank.glb", textured(trimesh.creation.box((0.1, 0.2, 0.02))))
    heavy = verdict_of(Catalogued("plank", plank, (0, 0, 0), False, 4.0))
    assert "4.00 kg" in (heavy.refusal or "")
    aside = verdict_of(Catalogued("plank", plank, (0, 0, 0), False, 0.2, "is set aside: ugly"))
    assert aside.refusal == "is set aside: ugly"
    assert aside.pieces == 1


def test_the_whole_catalogue_is_checked(assets):
    candidates = scan_candidates(assets / "scans")
    assert len(candidates) == 165
    mug = next(one for one in candidates if one.label == "ycb_025_mug")
    verdict = verdict_of(mug)
    assert verdict.refusal is None and np.isfinite(verdict.seconds) and verdict.seconds < 10
