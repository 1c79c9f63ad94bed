"""What light does in pictures: cast shadows, colour cast, exposure, backdrop; the bytes."""

import math
import os
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from lamps import lamp, shades
from probe.assets.environments.lens import taking
from probe.assets.procedural import build
from probe.assets.tabletops import tops
from probe.errors import UnknownName
from probe.render.illumination import AMBIENT, Illumination, Sun
from probe.render.lighting import light_of
from probe.render.renderer import Renderer
from probe.render.sunlight import illuminate
from probe.scene.lighting import AMBIENT as AMBIENT_LIGHTING
from probe.scene.lighting import Lighting, hdri, lighting_of
from probe.scene.scene import PlacedObject
from probe.scene.setup import UR5_TABLE
from probe.types import Pose
from shapes import box, card, grey_table, plain

POST = PlacedObject(1, "post", Pose())
CARD = PlacedObject(2, "card", Pose((0.0, 0.0, 0.001)))
CAMERA = UR5_TABLE.top.camera(256)


@pytest.fixture(scope="module")
def loaded(renderer):
    meshes = {"post": box(0.05, 0.05, 0.12, 200, 200, 200), "card": card(0.3, plain(255, 255, 255))}
    renderer.load(meshes | {"basket": build("proc_wicker_basket").mesh}, grey_table())
    return renderer


def test_a_shadow_falls_away_from_the_lamp_and_turns_with_it(loaded):
    at_x = shades(loaded.draw([POST], CAMERA, rgb=True, light=lamp()))
    assert at_x[1] < 0.9 * at_x[0] and min(at_x) == at_x[1]
    at_y = shades(loaded.draw([POST], CAMERA, rgb=True, light=lamp(yaw=math.pi / 2)))
    assert at_y[3] < 0.9 * at_y[2] and min(at_y) == at_y[3]


def test_ambient_light_casts_none(loaded):
    even = shades(loaded.draw([POST], CAMERA, rgb=True))
    assert max(even) - min(even) < 6


@pytest.mark.parametrize("colour", [(1.0, 1.0, 1.0), (1.0, 0.45, 0.4), (0.4, 0.6, 1.0)])
def test_a_white_card_takes_the_colour_of_its_surroundings(loaded, colour):
    frame = loaded.draw([CARD], CAMERA, rgb=True, light=lamp(colour))
    shown = frame.rgb[frame.labels == 2].mean(axis=0)
    assert 120 < shown.max() < 254
    # The brightest channel is exposed as white; the others keep their proportion, in linear light.
    linear = ((shown / 255 + 0.055) / 1.055) ** 2.4
    assert linear / linear.max() == pytest.approx(np.array(colour) / max(colour), abs=0.12)


def test_the_backdrop_is_what_lies_ahead(loaded):
    panorama = np.full((64, 128, 3), 0.5)
    panorama[:, 32:96] = (0.9, 0.1, 0.1)  # what is towards +y is red
    facing = loaded.draw([], UR5_TABLE.front.camera(128), rgb=True, light=illuminate(panorama, 0.0))
    turned = loaded.draw(
        [], UR5_TABLE.front.camera(128), rgb=True, light=illuminate(panorama, math.pi)
    )
    red, green, _ = facing.rgb[:20].mean(axis=(0, 1))
    assert red > green + 60
    assert np.ptp(turned.rgb[:20].mean(axis=(0, 1))) < 12
    plain_grey = loaded.draw([], UR5_TABLE.front.camera(128), rgb=True).rgb[:20].astype(int)
    assert np.ptp(plain_grey) <= 2 and 150 < plain_grey.mean() < 230


def test_bytes_depend_on_scene_camera_and_light_alone(loaded, tmp_path):
    meshes = {"post": box(0.05, 0.05, 0.12, 200, 200, 200), "card": card(0.3, plain(255, 255, 255))}
    ask = [(UR5_TABLE.front.camera(128), AMBIENT), (CAMERA, lamp())]
    first = [loaded.draw([POST, CARD], c, rgb=True, light=light).rgb for c, light in ask]
    with Renderer(tmp_path) as other:
        other.load(meshes, grey_table())
        for (c, light), expected in reversed(list(zip(ask, first, strict=True))):
            assert (other.draw([POST, CARD], c, rgb=True, light=light).rgb == expected).all()
    assert len({picture.tobytes() for picture in first}) == len(first)


def test_labels_and_depth_know_no_light(loaded):
    frames = [
        loaded.draw([POST], UR5_TABLE.front.camera(128), rgb=True, light=light)
        for light in (AMBIENT, lamp())
    ]
    assert (frames[0].labels == frames[1].labels).all()
    assert (frames[0].depth == frames[1].depth).all()


@pytest.mark.parametrize(("number", "way"), [(4, 1), (1, -1)])
def test_a_day_room_casts_shadows_away_from_its_window(loaded, number, way):
    light = light_of(Lighting(f"day_room_{number}"), None)
    frame = loaded.draw([POST], CAMERA, rgb=True, light=light)
    grey = np.where(frame.labels == 0, frame.rgb.astype(float).mean(axis=2), 255)
    dark = grey < 0.8 * np.median(grey)
    # Even ones have it at the left, so that shadows fall to the right, towards +x.
    assert dark.sum() > 50
    assert way * (np.argwhere(dark)[:, 1].mean() - 128) > 10


def test_a_day_room_shows_a_white_card_as_its_camera_is_set(loaded):
    light = light_of(Lighting("day_room_8"), None)
    white = loaded.draw([CARD], CAMERA, rgb=True, light=light)
    shown = ((white.rgb[white.labels == 2].mean(axis=0) / 255 + 0.055) / 1.055) ** 2.4
    assert shown == pytest.approx(np.array(taking(8).white), abs=0.06)


def _profile(loaded, sun, height):
    """Grey of the table from the edge of a card on, towards its shadow's edge, if it hangs so."""
    hung = PlacedObject(2, "card", Pose((0.0, 0.0, height)))
    light = Illumination(np.full((8, 16, 3), 0.3, np.float16), sun)
    frame = loaded.draw([hung], UR5_TABLE.top.camera(512), rgb=True, light=light)
    below = frame.rgb[256:, 256][frame.labels[256:, 256] == 0]
    return below.astype(float).mean(axis=1)


def test_a_near_windows_shadows_fade_with_the_distance_from_the_thing(loaded):
    window = Sun((0.0, 0.7071, 0.7071), (0.6, 0.6, 0.6), 3.0, 2.5)
    low, high = (_profile(loaded, window, height) for height in (0.03, 0.09))
    far = _profile(loaded, replace(window, distance=None), 0.09)
    steep_low, steep_high, steep_far = ((it[6:] - it[:-6]).max() for it in (low, high, far))
    # Three times as high, a third as steep; the rest of the light comes from all around.
    assert steep_low > 1.8 * steep_high
    assert steep_far > 2 * steep_high
    # Right beside the card it is as dark as in a sun's shadow.
    assert high[:10] == pytest.approx(far[:10], abs=2)


def test_a_thing_in_a_near_windows_light_does_not_float(loaded):
    """Its shadow begins where it stands: a lit rim in between was 5 rows wide once, faint in 7."""
    camera = UR5_TABLE.front.camera(1024)
    behind = -np.array(camera.world_from_camera.position[:2])
    x, y = behind / np.hypot(*behind) * math.sqrt(0.5)
    window = Sun((float(x), float(y), math.sqrt(0.5)), (0.6, 0.6, 0.6), 1.0, 2.4)
    light = Illumination(np.full((8, 16, 3), 0.3, np.float16), window)
    frame = loaded.draw([PlacedObject(3, "basket", Pose())], camera, rgb=True, light=light)
    rows, columns = np.nonzero(frame.labels == 3)
    foot = rows.max(), int(np.median(columns[rows == rows.max()]))
    below = frame.rgb[foot[0] + 1 : foot[0] + 60, foot[1]].astype(float).mean(axis=1)
    assert below.min() < 40
    assert np.argmax(below < 60) <= 4


@pytest.mark.slow
def test_bytes_of_a_day_room_are_the_same_in_another_process(loaded, tmp_path):
    def light():
        light_of.cache_clear()
        return light_of(Lighting("day_room_5"), None)

    camera = UR5_TABLE.front.camera(128)
    first = loaded.draw([POST, CARD], camera, rgb=True, light=light()).rgb
    loaded.draw([CARD], CAMERA, rgb=True, light=light_of(Lighting("day_room_6"), None))
    assert (loaded.draw([POST, CARD], camera, rgb=True, light=light()).rgb == first).all()
    script = (
        "import sys; from test_lighting import day_room_picture as draw;"
        "sys.stdout.buffer.write(draw())"
    )
    here = Path(__file__).parent
    search = [str(here), str(here.parent), *filter(None, sys.path)]
    other = subprocess.run(
        [sys.executable, "-c", script],
        env=os.environ | {"PYTHONPATH": os.pathsep.join(search)},
        capture_output=True,
        check=True,
        cwd=tmp_path,
    )
    assert other.stdout == first.tobytes()


def day_room_picture():
    """The picture of the test above, as bytes."""
    meshes = {"post": box(0.05, 0.05, 0.12, 200, 200, 200), "card": card(0.3, plain(255, 255, 255))}
    with Renderer() as it:
        it.load(meshes, grey_table())
        light = light_of(Lighting("day_room_5"), None)
        camera = UR5_TABLE.front.camera(128)
        rgb = it.draw([POST, CARD], camera, rgb=True, light=light).rgb
        assert rgb is not None
        return rgb.tobytes()


def test_names_lead_to_light():
    assert light_of(AMBIENT_LIGHTING, None) is AMBIENT
    assert light_of(hdri("cellar"), None).sun is not None
    window = light_of(Lighting("day_room_47"), None).sun
    assert window is not None and window.distance is not None
    with pytest.raises(UnknownName, match=r"neon.*ambient"):
        light_of(hdri("neon"), None)
    with pytest.raises(UnknownName, match="no lighting called .day_room_48"):
        light_of(Lighting("day_room_48"), None)


def test_a_table_stands_in_a_day_room_of_its_own():
    drawn = {lighting_of("day_room", table).name for table in tops()}
    assert len(drawn) > 40 and drawn <= {f"day_room_{n}" for n in range(48)}
    # The rooms that tables stand in are part of what a suite's seed fixes: they may not change.
    fixed = [lighting_of("day_room", it).name for it in ("oak_planks", "slate", "Wood027")]
    assert fixed == ["day_room_33", "day_room_1", "day_room_26"]
    assert lighting_of("cellar", "slate") == lighting_of("cellar", "cork") == hdri("cellar")
    assert lighting_of("day_room_7", "slate") == Lighting("day_room_7")
