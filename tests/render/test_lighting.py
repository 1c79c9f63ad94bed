"""What light does in pictures: cast shadows, colour cast, exposure, backdrop; the bytes."""

import math

import numpy as np
import pytest

from lamps import lamp, shades
from probe.errors import UnknownName
from probe.render.illumination import AMBIENT
from probe.render.lighting import light_of
from probe.render.renderer import Renderer
from probe.render.sunlight import illuminate
from probe.scene.lighting import AMBIENT as AMBIENT_LIGHTING
from probe.scene.lighting import ROOM, hdri
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
    renderer.load(meshes, grey_table())
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


def test_the_room_of_new_scenes_casts_shadows_and_hardly_colours(loaded):
    light = light_of(ROOM, None)
    shown = shades(loaded.draw([POST], CAMERA, rgb=True, light=light))
    assert shown[0] < 0.85 * shown[1]  # the window is at the left, so shadows fall to the right
    white = loaded.draw([CARD], CAMERA, rgb=True, light=light)
    card_colour = white.rgb[white.labels == 2].mean(axis=0)
    assert np.ptp(card_colour) < 20 and card_colour.max() > 215


def test_names_lead_to_light():
    assert light_of(AMBIENT_LIGHTING, None) is AMBIENT
    assert light_of(hdri("cellar"), None).sun is not None
    with pytest.raises(UnknownName, match=r"neon.*ambient"):
        light_of(hdri("neon"), None)
