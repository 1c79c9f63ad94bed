"""`probe assets` from outside: add, check, split, fetch."""

from __future__ import annotations

import json
import os
import subprocess
import sys

import pytest

from data_sets import box, obj_folder
from glb_files import textured, write_glb


def probe(*arguments, home, status=0):
    done = subprocess.run(
        [sys.executable, "-m", "probe", "assets", *map(str, arguments)],
        env={
            **os.environ,
            "PROBE_LIBRARY": str(home / "library"),
            "XDG_CACHE_HOME": str(home / "cache"),
            "COLUMNS": "160",
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
    assert "4 objects: 3 OK, 1 refused" in probe("check", things, home=tmp_path)
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


@pytest.mark.slow
def test_what_cant_be_done_is_told_in_a_line(tmp_path):
    obj_folder(tmp_path / "set")
    told = probe("add", "gso", tmp_path / "set", home=tmp_path, status=1)
    assert "holds no objects of the format gso" in told
    assert "probe assets add" in probe("check", home=tmp_path, status=1)
    assert "gso/..." in probe("fetch", "nowhere/x", home=tmp_path, status=1)
