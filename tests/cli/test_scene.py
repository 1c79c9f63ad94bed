"""`probe scene` from outside: files, bytes, errors."""

import json
import os
import subprocess
import sys

import numpy as np
import pytest
from PIL import Image

from probe.cli.scene import PAGE, _check_gallery


def probe(*arguments, **environment):
    return subprocess.run(
        [sys.executable, "-m", "probe", *map(str, arguments)],
        env={**os.environ, **environment},
        capture_output=True,
        text=True,
        check=False,
    )


@pytest.fixture(scope="module")
def written(tmp_path_factory):
    folder = tmp_path_factory.mktemp("scene")
    result = probe("scene", 5, "--objects", 6, "--out", folder)
    assert result.returncode == 0, result.stderr
    return folder


@pytest.mark.slow
def test_the_four_files_agree_with_one_another(written):
    assert sorted(path.name for path in written.iterdir()) == [
        "depth.png",
        "labels.png",
        "picture.png",
        "scene.json",
    ]
    picture = np.asarray(Image.open(written / "picture.png"))
    depth = np.asarray(Image.open(written / "depth.png"))
    labels = np.asarray(Image.open(written / "labels.png"))
    scene = json.loads((written / "scene.json").read_text())
    assert picture.shape == (1024, 1024, 3)
    assert depth.shape == labels.shape == (1024, 1024)
    assert set(np.unique(labels)) <= {0} | {item["instance"] for item in scene["objects"]}
    assert len(scene["objects"]) == 6
    assert np.median(depth[labels == 0]) == pytest.approx(12_000, abs=2)
    assert depth[labels > 0].max() < 12_010


@pytest.mark.slow
def test_another_process_writes_the_same_bytes(written, tmp_path):
    result = probe("scene", 5, "--objects", 6, "--out", tmp_path)
    assert result.returncode == 0, result.stderr
    for path in written.iterdir():
        assert path.read_bytes() == (tmp_path / path.name).read_bytes(), path.name


@pytest.mark.slow
def test_light_and_camera_change_the_picture_alone(written, tmp_path):
    looks = ["--lighting", "cellar", "--camera", "front"]
    result = probe("scene", 5, "--objects", 6, *looks, "--out", tmp_path)
    assert result.returncode == 0, result.stderr
    scenes = [json.loads((f / "scene.json").read_text()) for f in (tmp_path, written)]
    assert [scene["setup"].pop("lighting") for scene in scenes] == ["cellar", "day_room"]
    assert scenes[0] == scenes[1]
    pictures = [np.asarray(Image.open(f / "picture.png")) for f in (tmp_path, written)]
    assert pictures[0].shape == (1024, 1024, 3)
    assert (pictures[0] != pictures[1]).mean() > 0.9


@pytest.mark.parametrize(
    ("arguments", "environment", "words"),
    [
        (["--objects", 5000], {}, "--objects: 5000 is out of range. Say 1 to 200"),
        (["--pool", "scans"], {"PROBE_ASSETS": ""}, "probe assets fetch v1-scans"),
        ([], {"VK_ICD_FILENAMES": "/nowhere", "VK_DRIVER_FILES": "/nowhere"}, "mesa-vulkan"),
        (["--out", "/proc/nowhere"], {}, "/proc/nowhere"),
        (["--lighting", "disco"], {"PROBE_ASSETS": ""}, "morning_kitchen"),
    ],
    ids=["too many", "no scans", "no driver", "unwritable", "no such light"],
)
def test_failures_are_one_line_with_a_remedy(tmp_path, arguments, environment, words):
    out = [] if "--out" in arguments else ["--out", tmp_path / "out"]
    result = probe("scene", 5, *arguments, *out, **environment)
    assert result.returncode == 1
    assert words in result.stderr
    assert len(result.stderr.strip().splitlines()) == 1
    assert not (tmp_path / "out").exists()


def test_a_gallery_of_other_scenes_is_left_alone(tmp_path):
    for seed in (3, 4):
        (tmp_path / str(seed)).mkdir()
    (tmp_path / PAGE).write_text("a gallery")
    for words in ((5,), (4, "--gallery", 2)):
        refused = probe("scene", *words, "--out", tmp_path)
        assert refused.returncode == 1
        assert "holds a gallery of 2 other scenes. Say another --out" in refused.stderr
    assert (tmp_path / PAGE).read_text() == "a gallery"
    # The same gallery is drawn again, or taken further.
    _check_gallery(tmp_path, range(3, 6))
