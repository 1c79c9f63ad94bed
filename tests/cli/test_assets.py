"""`probe assets` from outside: add, check, split, fetch."""

from __future__ import annotations

import csv
import json
import os
import subprocess
import sys

import pytest
import trimesh

from data_sets import box, obj_folder
from glb_files import textured, write_glb
from probe.assets.gltf.glb import glb_bytes
from probe.assets.importers.adding import find_sources
from probe.assets.importers.normalised import normalised
from probe.assets.importers.options import ImportOptions
from probe.assets.pools.own import store_object


def sphere():
    return trimesh.creation.icosphere(4, 0.03).apply_translation((0, 0, 0.03))


def probe(*arguments, home, status=0, columns=160):
    done = subprocess.run(
        [sys.executable, "-m", "probe", "assets", *map(str, arguments)],
        env={
            **os.environ,
            "PROBE_LIBRARY": str(home / "library"),
            "XDG_CACHE_HOME": str(home / "cache"),
            "COLUMNS": str(columns),
        },
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == status, done.stderr
    assert "Traceback" not in done.stderr
    return done.stdout + done.stderr


@pytest.mark.slow
def test_objects_are_added_checked_and_split_with_near_duplicates_together(tmp_path):
    things = tmp_path / "things"
    things.mkdir()
    write_glb(things / "brick.glb", textured(box()))
    write_glb(things / "blue_brick.glb", textured(box(), (20, 40, 210)))
    write_glb(things / "tray.glb", textured(box((0.2, 0.05, 0.02))))
    (things / "broken.glb").write_bytes(b"glTF")
    told = probe("add", "gltf", things, "--licence", "MIT", "--workers", 1, home=tmp_path)
    assert "3 added, 0 skipped, 1 refused" in told
    assert "this is no GLB file" in told
    assert "own_blue_brick" in told.split("near-duplicates")[1]
    again = probe("add", "gltf", things, "--licence", "MIT", "--workers", 1, home=tmp_path)
    assert "0 added, 3 skipped, 1 refused" in again
    assert "own_tray" in probe("list", "--pool", "own", home=tmp_path)
    assert "4 objects: 3 OK, 1 refused" in probe("check", things, home=tmp_path, status=1)
    split = tmp_path / "split.json"
    probe("split", "--pool", "own", "--out", split, "--workers", 1, home=tmp_path)
    parts = json.loads(split.read_text())["parts"]
    assert parts["own_brick"] == parts["own_blue_brick"]
    parts["own_brick"] = "train" if parts["own_brick"] == "evaluation" else "evaluation"
    planted = json.dumps({"parts": parts})
    split.write_text(planted)
    told = probe("split", "--pool", "own", "--out", split, "--workers", 1, home=tmp_path, status=1)
    assert "near-duplicate" in told
    assert split.read_text() == planted


def test_no_name_in_the_list_is_cut_where_it_goes_to_a_file(tmp_path):
    write_glb(tmp_path / "x.glb", textured(box()))
    (source,) = find_sources(tmp_path / "x.glb", ImportOptions("gltf"))
    mesh, entry = normalised(source, ImportOptions("gltf"))
    words = {"id": f"own_{'long_' * 8}tin", "name": "turquoise tea tin", "mass": 0.003}
    store_object(tmp_path / "library", entry.model_copy(update=words), glb_bytes(mesh))
    told = probe("list", "--pool", "own", home=tmp_path, columns=80)
    assert all(str(word) in told for word in words.values())


@pytest.mark.slow
def test_what_cant_be_done_is_told_in_a_line(tmp_path):
    obj_folder(tmp_path / "set")
    told = probe("add", "gso", tmp_path / "set", home=tmp_path, status=1)
    assert "holds no objects of the format gso" in told
    assert "probe assets add" in probe("check", home=tmp_path, status=1)
    assert "gso/..." in probe("fetch", "nowhere/x", home=tmp_path, status=1)


@pytest.mark.slow
def test_a_folder_of_scans_is_added_and_reviewed_without_a_model(tmp_path):
    set_ = tmp_path / "ycb"
    for name, mesh in (("003_red_tin", box()), ("014_lemon", sphere())):
        home = set_ / name / "google_16k"
        obj_folder(home, mesh)
        (home / "model.obj").rename(home / "textured.obj")
        (home / "model.mtl").unlink()
        (home / "textured_coll.obj").write_text("v 0 0 0\n")
    told = probe("check", set_, "--up", "z", home=tmp_path)
    assert "2 objects: 2 OK, 0 refused" in told and "2 meshes are passed over" in told
    assert "about files" in probe("check", "own", "--up", "z", home=tmp_path, status=1)
    told = probe("add", "obj", set_, "--workers", 1, home=tmp_path)
    assert "2 added, 0 skipped, 0 refused" in told
    assert "the only picture beside it" in " ".join(told.replace("│", " ").split())
    out = tmp_path / "review"
    assert "2 objects" in probe("review", out, home=tmp_path)
    with (out / "review.csv").open(newline="") as file:
        rows = list(csv.DictReader(file))
    assert [(row["id"], row["name"], row["category"]) for row in rows] == [
        ("own_lemon", "lemon", "lemon"),
        ("own_red_tin", "red tin", "tin"),
    ]
    assert {picture.name for picture in (out / "pictures").glob("*.jpg")} >= {
        "own_lemon.jpg",
        "own_red_tin.jpg",
    }
    rows[1] |= {"name": "tea tin", "mass_kg": "0.2"}
    with (out / "review.csv").open("w", newline="") as file:
        writer = csv.DictWriter(file, list(rows[0]))
        writer.writeheader()
        writer.writerows(rows)
    assert "1 objects corrected" in probe("review", out, home=tmp_path)
    entry = json.loads((tmp_path / "library" / "own_red_tin" / "entry.json").read_text())
    assert (entry["name"], entry["mass"]) == ("tea tin", 0.2)
    assert "tea tin" in (out / "review.html").read_text()
