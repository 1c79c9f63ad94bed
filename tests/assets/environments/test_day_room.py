"""The rooms that new scenes stand in, and how a camera takes them."""

import numpy as np
import pytest

from probe.assets.environments.casting import cast
from probe.assets.environments.day_room import COUNT, day_room, day_room_number
from probe.assets.environments.lens import out_of_focus, taking
from probe.assets.environments.painter import sketch_room
from probe.assets.environments.room import SIDES, Furniture, Room, WallPatch
from probe.render.illumination import directions
from probe.render.sunlight import SHARES, illuminate


def test_names_have_numbers():
    assert day_room_number("day_room_0") == 0
    assert day_room_number(f"day_room_{COUNT - 1}") == COUNT - 1
    for other in (f"day_room_{COUNT}", "day_room_-1", "day_room_007", "day_room", "cellar"):
        assert day_room_number(other) is None


@pytest.mark.parametrize("number", range(0, COUNT, 5))
def test_the_key_light_is_at_one_side_and_casts_shadows(number):
    light = illuminate(sketch_room(day_room(number), 128), 0.0, taking(number))
    assert light.sun is not None
    aside, _, up = light.sun.towards
    assert np.sign(aside) == (-1 if number % 2 == 0 else 1)
    assert np.degrees(np.arcsin(up)) < 75
    lit = np.array(light.sun.irradiance) * up
    share = (lit / np.array(taking(number).white)).mean()
    assert SHARES[0] < share < SHARES[1] + 0.05


def test_no_two_rooms_look_alike_ahead():
    ahead = [sketch_room(day_room(n), 32)[16:20, 24:40].ravel() for n in range(COUNT)]
    apart = [np.abs(a - b).mean() for k, a in enumerate(ahead) for b in ahead[:k]]
    assert min(apart) > 0.01


@pytest.mark.parametrize("number", range(0, COUNT, 7))
def test_something_stands_ahead(number):
    hits = cast(day_room(number), 128)
    seen = hits.side[66:76, 110:146]  # from 3 to 17 degrees below the horizon
    assert len(np.unique(seen)) > 3
    assert (seen >= len(SIDES)).mean() > 0.1


def test_white_stays_between_grey_and_glaring():
    whites = np.array([taking(n).white for n in range(COUNT)])
    assert whites.max() <= 1.0 and whites.max(axis=1).min() > 0.55
    assert (whites.min(axis=1) / whites.max(axis=1)).min() > 0.6
    assert np.ptp(whites.max(axis=1)) > 0.3


def test_a_lens_makes_a_disc_of_a_point():
    sharp = np.zeros((180, 360, 3))
    sharp[90, 100] = (8.0, 4.0, 0.0)
    blurred = out_of_focus(sharp, 12.0)
    assert blurred.sum(axis=(0, 1)) == pytest.approx([8.0, 4.0, 0.0], rel=1e-3, abs=1e-3)
    bright = np.argwhere(blurred[..., 0] > 0.5 * blurred[..., 0].max())
    assert np.ptp(bright, axis=0) + 1 == pytest.approx([12, 12], abs=1)
    assert len(bright) == pytest.approx(np.pi * 6**2, rel=0.1)


def test_a_ball_is_round_and_ends_where_its_box_does():
    ball = Furniture(low=(-0.5, 1.5, 0.5), high=(0.5, 2.5, 1.5), colour="#ff0000", round=True)
    room = Room(
        id="it",
        size=(8, 8, 3),
        eye=1.0,
        walls="#808080",
        floor="#808080",
        patches=(),
        boxes=(ball,),
    )
    hits = cast(room, 180)
    on = hits.side == len(SIDES)
    # Half a metre wide either way, its middle two metres off: a cone of asin(1/4).
    towards = directions(180)[on]
    assert np.degrees(np.arccos(towards[:, 1])).max() == pytest.approx(14.5, abs=1)
    assert hits.points[1][on].min() == pytest.approx(1.5, abs=0.01)


def test_a_box_keeps_light_from_the_floor_beside_it():
    lamp = WallPatch(side="ceiling", at=(0.0, 0.0), size=(0.5, 0.5), colour="#ffffff", glow=9)
    room = Room(id="it", size=(6, 6, 3), walls="#f4f4f4", floor="#f4f4f4", patches=(lamp,))
    crate = Furniture(low=(-0.4, 1.2, 0.0), high=(0.4, 2.0, 0.4), colour="#000000")
    bare = sketch_room(room, 64)
    shaded = sketch_room(room.model_copy(update={"shading": (crate,)}), 64)
    below = shaded[42:48, 62:66] / bare[42:48, 62:66]
    assert below.min() < 0.8 and shaded.max() <= bare.max()
    assert shaded[40:, :8] == pytest.approx(bare[40:, :8], rel=0.01)  # behind
