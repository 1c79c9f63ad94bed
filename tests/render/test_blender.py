"""Blender's pictures beside Filament's: the same scene, aligned, in the same colours; the bytes."""

import os
import resource
import signal
from dataclasses import replace
from importlib.util import find_spec

import numpy as np
import psutil
import pytest
from scipy.ndimage import binary_erosion, gaussian_filter

from lamps import lamp, shades
from probe.errors import MissingExtra
from probe.render import driver
from probe.render.illumination import AMBIENT, Illumination, Sun
from probe.render.renderer import Renderer
from probe.scene.scene import PlacedObject
from probe.scene.setup import UR5_TABLE
from probe.types import Pose
from shapes import box, card, grey_table, plain

CAMERA = UR5_TABLE.top.camera(256)
COLOURS = {"red": (200, 40, 30), "sand": (210, 190, 140), "navy": (30, 40, 110)}
CARDS = [
    PlacedObject(n, name, Pose((0.16 * (n - 2), 0.15, 0.001)))
    for n, name in enumerate(COLOURS, start=1)
]
POST = PlacedObject(4, "post", Pose())

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(find_spec("bpy") is None, reason="Blender's package isn't installed"),
]


@pytest.fixture(scope="module", params=["filament", "blender"])
def drawing(request):
    with Renderer(engine=request.param) as it:
        load(it)
        yield it


@pytest.fixture(scope="module")
def blender():
    with Renderer(engine="blender") as it:
        load(it)
        yield it


def load(renderer):
    cards = {name: card(0.1, plain(*rgb)) for name, rgb in COLOURS.items()}
    renderer.load(cards | {"post": box(0.05, 0.05, 0.12, 200, 200, 200)}, grey_table())


def test_ambient_light_shows_a_card_in_its_own_colour(drawing):
    frame = drawing.draw(CARDS, CAMERA, rgb=True)
    for item in CARDS:
        shown = frame.rgb[binary_erosion(frame.labels == item.instance, iterations=3)]
        assert np.abs(shown.mean(axis=0) - COLOURS[item.object_id]).max() <= 8


def test_a_shadow_falls_away_from_the_lamp(drawing):
    lit = shades(drawing.draw([POST], CAMERA, rgb=True, light=lamp()))
    assert lit[1] < 0.9 * lit[0] and min(lit) == lit[1]
    even = shades(drawing.draw([POST], CAMERA, rgb=True))
    assert max(even) - min(even) < 6


def test_a_near_window_lights_a_card_as_much_as_it_says(drawing):
    window = Sun((0.6, 0.0, 0.8), (0.5, 0.5, 0.5), 2.0, 2.5)
    dark = Illumination(np.full((8, 16, 3), 1e-3, np.float16), window)
    frame = drawing.draw(CARDS[1:2], CAMERA, rgb=True, light=dark)
    shown = frame.rgb[binary_erosion(frame.labels == 2, iterations=3)].mean(axis=0)
    own = np.array(COLOURS["sand"])
    light = (((shown / 255 + 0.055) / 1.055) / ((own / 255 + 0.055) / 1.055)) ** 2.4
    # It faces the window by 0.8; its gloss adds a little, and EEVEE's discs shine 8 % less.
    assert light == pytest.approx(0.8 * 0.5, rel=0.2)


def test_a_grainless_picture_shows_the_same_shadow_without_grain(blender):
    window = Sun((0.6, 0.0, 0.8), (0.5, 0.5, 0.5), 3.0, 2.5)
    light = Illumination(np.full((8, 16, 3), 0.2, np.float16), window)
    first = picture(blender, light)
    smooth = blender.draw([POST], CAMERA, rgb=True, light=light, grainless=True)
    assert picture(blender, light) == first
    usual = np.frombuffer(first, np.uint8).reshape(smooth.rgb.shape)
    bare = binary_erosion(smooth.labels == 0, iterations=4)
    assert grain(smooth.rgb, bare) < 0.5 * grain(usual, bare)
    assert np.abs(smooth.rgb.astype(int) - usual)[bare].mean() < 2


def grain(picture, where):
    """How far a pixel is off what lies around it: the 99th percentile in a part of a picture."""
    grey = picture.astype(float).mean(axis=2)
    return np.percentile(np.abs(grey - gaussian_filter(grey, 1.5))[where], 99)


def test_surroundings_tint_everything(drawing):
    frame = drawing.draw([POST], CAMERA, rgb=True, light=lamp((1.0, 0.45, 0.4)))
    red, green, blue = frame.rgb.reshape(-1, 3).mean(axis=0)
    assert red > 1.25 * green and red > 1.25 * blue


@pytest.mark.parametrize("camera", [CAMERA, UR5_TABLE.front.camera(256)], ids=["top", "front"])
def test_pictures_lie_on_the_labels_to_a_pixel(drawing, camera):
    frame = drawing.draw([*CARDS, POST], camera, rgb=True)
    edges = outline(frame.labels)
    steps = outline(frame.rgb.astype(float).sum(axis=2))
    fit = {
        (v, u): np.corrcoef(edges.ravel(), np.roll(steps, (v, u), (0, 1)).ravel())[0, 1]
        for v in (-2, -1, 0, 1, 2)
        for u in (-2, -1, 0, 1, 2)
    }
    v, u = max(fit, key=lambda shift: fit[shift])
    assert abs(v) <= 1 and abs(u) <= 1


def outline(picture):
    """How much a picture changes at each pixel, both ways about it alike; steps count as one."""
    down, across = np.gradient(np.asarray(picture, float))
    changes = np.abs(down) + np.abs(across)
    return np.minimum(changes, 0.5 * np.percentile(changes[changes > 0], 90))


def test_bytes_do_not_depend_on_what_was_drawn_before(blender):
    first = picture(blender, lamp())
    blender.draw(CARDS, UR5_TABLE.front.camera(256), rgb=True, light=AMBIENT)
    assert picture(blender, lamp()) == first
    with Renderer(engine="blender") as another:
        load(another)
        assert picture(another, lamp()) == first


def picture(renderer, light=AMBIENT):
    return renderer.draw([POST], CAMERA, rgb=True, light=light).rgb.tobytes()


def test_a_series_shows_each_moment_and_always_in_the_same_bytes(blender):
    aside = replace(POST, pose=Pose((0.1, 0.1, 0.0)))
    moments = [[POST], [aside], CARDS, [POST]]
    shown = blender.series(moments, CAMERA, lamp(), 20.0)
    with Renderer(engine="blender") as another:
        load(another)
        again = another.series(moments[:2], CAMERA, lamp(), 20.0)
    assert [one.tobytes() for one in again] == [one.tobytes() for one in shown[:2]]
    alone = [
        blender.draw(moment, CAMERA, rgb=True, light=lamp()).rgb.astype(int)
        for moment in moments[:3]
    ]
    # Series are drawn with fewer samples.
    off = [[np.abs(one - other).mean() for other in alone] for one in shown]
    assert [int(np.argmin(row)) for row in off[:3]] == [0, 1, 2]
    assert max(off[n][n] for n in range(3)) < 2
    assert np.abs(shown[0].astype(int) - shown[3]).mean() < 0.5


def test_a_series_doesn_t_see_beyond_its_horizon(blender):
    (near,) = blender.series([[POST]], CAMERA, AMBIENT, 0.3)
    assert np.ptp(near.reshape(-1, 3), axis=0).max() <= 1


def test_the_time_that_blender_took_is_known_when_it_has_ended():
    before = children_seconds()
    with Renderer(engine="blender") as renderer:
        load(renderer)
        picture(renderer)
        processes = psutil.Process(renderer.pid).children(recursive=True)
        easel = next(p for p in processes if "probe.render.blender" in p.cmdline())
        took = easel.cpu_times().user
    assert children_seconds() - before >= took > 1


def children_seconds():
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime


def test_a_killed_blender_is_started_again_and_none_is_left(blender):
    with Renderer(engine="blender") as renderer:
        load(renderer)
        first = picture(renderer)
        processes = psutil.Process(renderer.pid).children(recursive=True)
        easel = next(p for p in processes if "probe.render.blender" in p.cmdline())
        os.kill(easel.pid, signal.SIGKILL)
        assert picture(renderer) == first
        processes = psutil.Process(renderer.pid).children(recursive=True)
    gone, alive = psutil.wait_procs(processes, timeout=10)
    assert gone and not alive


def test_a_missing_package_is_named(monkeypatch):
    driver.require_blender.cache_clear()
    monkeypatch.setattr(driver, "find_spec", lambda name: None)
    with pytest.raises(MissingExtra, match=r"'\.\[blender\]'"):
        Renderer(engine="blender")
    driver.require_blender.cache_clear()
