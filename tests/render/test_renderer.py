"""Pictures, depth and labels: against geometry, against a ray cast, byte by byte."""

import hashlib
import os
import signal
import subprocess
import sys
from pathlib import Path

import numpy as np
import psutil
import pytest

from probe.errors import NoGraphicsDriver, RenderFailed
from probe.render.illumination import AMBIENT
from probe.render.renderer import Renderer
from probe.scene.scene import PlacedObject
from probe.scene.setup import UR5_TABLE
from probe.types import Camera, Pose, looking_at
from raycast import away_from_edges, cast
from shapes import box, card, grey_table, plain

MESHES = {
    "slab": box(0.20, 0.12, 0.04, 200, 40, 30),
    "cube": box(0.06, 0.06, 0.06, 30, 90, 200),
    "post": box(0.03, 0.03, 0.18, 230, 220, 40),
}
TILTED = Pose.of(np.array([0.02, 0.05, 0.09]), np.array([0.8, 0.3, 0.2, 0.4]))
OBJECTS = (
    PlacedObject(1, "slab", Pose((0.0, 0.0, 0.0))),
    PlacedObject(2, "cube", Pose((0.05, -0.05, 0.0))),
    PlacedObject(5, "post", Pose((-0.2, 0.15, 0.0))),
    PlacedObject(300, "cube", TILTED),
)


@pytest.fixture(scope="module")
def loaded(renderer):
    renderer.load(MESHES, grey_table())
    return renderer


@pytest.mark.parametrize(
    "camera",
    [
        UR5_TABLE.top.camera(512),
        Camera(looking_at(np.array([0.5, -0.6, 0.7]), np.array([0.0, 0.0, 0.05])), 640, 480, 40),
    ],
    ids=["top", "oblique"],
)
def test_labels_and_depth_agree_with_a_ray_cast(loaded, camera):
    frame = loaded.draw(OBJECTS, camera, rgb=False)
    labels, depth = cast(OBJECTS, MESHES, camera, UR5_TABLE.table_size)
    on_objects = (labels > 0) | (frame.labels > 0)
    assert on_objects.sum() > 5_000
    assert (frame.labels == labels)[on_objects].mean() > 0.995
    flat = away_from_edges(depth)
    assert flat.mean() > 0.5
    assert np.abs(frame.depth - depth)[flat].max() < 1e-3
    assert set(np.unique(frame.labels)) == {0, 1, 2, 5, 300}


def test_the_table_is_where_the_camera_says(loaded):
    camera = UR5_TABLE.top.camera(256)
    frame = loaded.draw((), camera, rgb=False)
    assert np.allclose(frame.depth, 1.20, atol=1e-5)
    assert (frame.labels == 0).all()


def test_right_is_x_and_up_is_y(loaded):
    camera = UR5_TABLE.top.camera(256)
    east = loaded.draw([PlacedObject(1, "cube", Pose((0.2, 0, 0)))], camera, rgb=False).labels
    north = loaded.draw([PlacedObject(1, "cube", Pose((0, 0.2, 0)))], camera, rgb=False).labels
    assert np.nonzero(east)[1].mean() > 200
    assert np.nonzero(north)[0].mean() < 56


def test_labels_alone_are_those_of_a_frame(loaded):
    alone = loaded.labels(OBJECTS, UR5_TABLE.camera())
    frame = loaded.draw(OBJECTS, UR5_TABLE.camera(), rgb=False)
    assert alone.dtype == frame.labels.dtype and np.array_equal(alone, frame.labels)
    assert set(np.unique(alone)) == {0, *(item.instance for item in OBJECTS)}


def test_colours_alone_are_those_of_a_frame(loaded):
    camera = UR5_TABLE.top.camera(256)
    alone = loaded.paint(OBJECTS, camera)
    assert (alone == loaded.draw(OBJECTS, camera, rgb=True).rgb).all()
    assert alone.std() > 10


def test_outlines_show_each_object_alone(loaded):
    camera = UR5_TABLE.top.camera(512)
    outlines = loaded.outlines(OBJECTS, camera)
    for item in OBJECTS:
        labels, _ = cast([item], MESHES, camera, UR5_TABLE.table_size)
        assert np.count_nonzero(outlines[item.instance] != (labels > 0)) <= 4
    # The tilted cube covers part of the slab: alone, the slab shows more.
    together = loaded.draw(OBJECTS, camera, rgb=False).labels
    assert np.count_nonzero(outlines[1]) > np.count_nonzero(together == 1)


def test_a_flat_patch_keeps_its_texture_s_colours(renderer):
    ramp = np.linspace(0, 255, 16).astype(np.uint8)
    texture = np.zeros((16, 16, 3), np.uint8)
    texture[..., 0], texture[..., 1], texture[..., 2] = ramp, ramp[:, None], ramp[::-1]
    texture = np.kron(texture, np.ones((32, 32, 1), np.uint8))
    renderer.load({"card": card(0.3, texture)}, grey_table())
    camera = UR5_TABLE.top.camera(1024)
    # Above the table, so that its closeness darkens nothing.
    item = PlacedObject(1, "card", Pose((0, 0, 0.3)))
    frame = renderer.draw([item], camera, rgb=True)
    v, u = np.nonzero(frame.labels == 1)
    rows = (np.arange(v.min(), v.max() + 1) - v.min() + 0.5) / (v.max() + 1 - v.min()) * 512
    columns = (np.arange(u.min(), u.max() + 1) - u.min() + 0.5) / (u.max() + 1 - u.min()) * 512
    expected = texture[rows.astype(int)[:, None], columns.astype(int)]
    shown = frame.rgb[v.min() : v.max() + 1, u.min() : u.max() + 1].astype(int)
    assert shown.shape[0] > 500
    assert np.abs(shown - expected).mean() < 4


def test_bytes_depend_on_the_request_alone(loaded):
    loaded.load(MESHES, grey_table())
    camera = UR5_TABLE.top.camera(256)
    first = loaded.draw(OBJECTS, camera, rgb=True)
    loaded.draw(OBJECTS[:2], camera, rgb=True)
    loaded.outlines(OBJECTS, camera)
    again = loaded.draw(OBJECTS, camera, rgb=True)
    with Renderer() as other:
        other.load(dict(reversed(MESHES.items())), grey_table())
        elsewhere = other.draw(OBJECTS, camera, rgb=True)
    for frame in (again, elsewhere):
        assert (frame.rgb == first.rgb).all()
        assert (frame.depth == first.depth).all()
        assert (frame.labels == first.labels).all()


def test_a_killed_worker_costs_one_retry(loaded):
    loaded.load(MESHES, grey_table())
    camera = UR5_TABLE.top.camera(128)
    before = loaded.draw(OBJECTS, camera, rgb=True)
    os.kill(loaded.pid, signal.SIGKILL)
    after = loaded.draw(OBJECTS, camera, rgb=True)
    assert (before.rgb == after.rgb).all()


def test_dying_twice_is_an_error_that_says_so(loaded, monkeypatch):
    loaded.load(MESHES, grey_table())
    with pytest.raises(RenderFailed, match="died twice"):
        loaded.draw(OBJECTS, UR5_TABLE.top.camera(-1), rgb=False)
    assert loaded.draw(OBJECTS, UR5_TABLE.top.camera(128), rgb=False).labels.any()


def test_what_isn_t_loaded_is_named(loaded):
    loaded.load(MESHES, grey_table())
    stray = [*OBJECTS, PlacedObject(7, "stray", Pose())]
    asked = (
        lambda: loaded.draw(stray, UR5_TABLE.top.camera(128), rgb=False),
        lambda: loaded.labels(stray, UR5_TABLE.top.camera(128)),
        lambda: loaded.outlines(stray, UR5_TABLE.top.camera(128)),
    )
    for ask in asked:
        with pytest.raises(ValueError, match="load.*: stray$"):
            ask()
    with pytest.raises(ValueError, match="load"):
        Renderer().labels([], UR5_TABLE.top.camera(128))


def test_no_process_outlives_its_renderer():
    with Renderer() as it:
        it.load(MESHES, grey_table())
        it.draw(OBJECTS, UR5_TABLE.top.camera(128), rgb=True)
        family = [psutil.Process(it.pid), *psutil.Process(it.pid).children(recursive=True)]
        assert len(family) >= 2
    _, alive = psutil.wait_procs(family, timeout=5)
    assert not alive


def test_a_killed_worker_leaves_no_children():
    it = Renderer()
    it.load(MESHES, grey_table())
    it.draw(OBJECTS, UR5_TABLE.top.camera(128), rgb=False)
    worker = psutil.Process(it.pid)
    children = worker.children(recursive=True)
    assert children
    worker.kill()
    _, alive = psutil.wait_procs(children, timeout=5)
    it.close()
    assert not alive


def test_no_driver_is_one_clear_error():
    code = "from probe.render.renderer import Renderer; Renderer()"
    environment = {**os.environ, "VK_ICD_FILENAMES": "/nowhere.json", "VK_DRIVER_FILES": "/nowhere"}
    found = subprocess.run(
        [sys.executable, "-c", code], env=environment, capture_output=True, text=True, check=False
    )
    assert found.returncode == 1
    assert NoGraphicsDriver.__name__ in found.stderr.splitlines()[-1]
    assert "mesa-vulkan-drivers" in found.stderr


@pytest.mark.slow
def test_pictures_are_the_same_in_another_process(loaded, tmp_path: Path):
    loaded.load(MESHES, grey_table())
    here = loaded.draw(OBJECTS, UR5_TABLE.top.camera(256), rgb=True)
    script = tmp_path / "draw.py"
    script.write_text(
        "import hashlib, sys; sys.path.insert(0, sys.argv[1])\n"
        "import test_renderer as t\n"
        "with t.Renderer() as r:\n"
        "    r.load(t.MESHES, t.grey_table())\n"
        "    f = r.draw(t.OBJECTS, t.UR5_TABLE.top.camera(256), rgb=True)\n"
        "print(hashlib.sha256(f.rgb.tobytes() + f.depth.tobytes()).hexdigest())\n"
    )
    tests = Path(__file__).parents[1]
    there = subprocess.run(
        [sys.executable, str(script), str(Path(__file__).parent)],
        env={**os.environ, "PYTHONPATH": str(tests)},
        capture_output=True,
        text=True,
        check=True,
    )
    expected = hashlib.sha256(here.rgb.tobytes() + here.depth.tobytes()).hexdigest()
    assert there.stdout.strip() == expected


def test_a_one_pixel_texture_is_enough(renderer):
    renderer.load({"cube": MESHES["cube"]}, grey_table())
    frame = renderer.draw([PlacedObject(1, "cube", Pose())], UR5_TABLE.top.camera(128), rgb=True)
    seen = frame.rgb[frame.labels == 1].mean(axis=0)
    assert np.abs(seen - plain(30, 90, 200)[0, 0]).max() < 25


def test_a_series_has_the_same_bytes_each_time_and_changes_no_other_picture(loaded):
    loaded.load(MESHES, grey_table())
    camera = Camera(
        looking_at(np.array([0.5, -0.6, 0.7]), np.array([0.0, 0.0, 0.05])), 320, 240, 40
    )
    before = loaded.draw(OBJECTS, camera, rgb=True).rgb
    moments = [OBJECTS, OBJECTS[:2], OBJECTS]
    series = loaded.series(moments, camera, AMBIENT, far=9.0)
    assert [picture.shape for picture in series] == [(240, 320, 3)] * 3
    assert (series[0] != series[1]).any(axis=-1).sum() > 500
    again = loaded.series(moments, camera, AMBIENT, far=9.0)
    assert [a.tobytes() for a in series] == [a.tobytes() for a in again]
    assert loaded.draw(OBJECTS, camera, rgb=True).rgb.tobytes() == before.tobytes()


def test_a_series_sees_further_than_a_picture(loaded):
    loaded.load(MESHES, grey_table())
    far_off = Camera(looking_at(np.array([4.0, -4.0, 2.0]), np.zeros(3)), 320, 240, 10)
    picture = loaded.draw(OBJECTS, far_off, rgb=True).rgb
    (seen,) = loaded.series([OBJECTS], far_off, AMBIENT, far=9.0)
    assert np.unique(picture.reshape(-1, 3), axis=0).shape[0] < 8
    assert np.unique(seen.reshape(-1, 3), axis=0).shape[0] > 50
