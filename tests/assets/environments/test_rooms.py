import numpy as np
import pytest

from probe.assets.environments import environment_names, load_environment
from probe.assets.environments.painter import paint_room
from probe.assets.environments.room import Room, WallPatch, rooms
from probe.errors import UnknownName
from probe.render.illumination import directions


def test_there_are_rooms_without_assets():
    assert len(environment_names(None)) >= 12
    assert set(environment_names(None)) == set(rooms())


def test_a_room_is_painted_the_same_each_time():
    first = load_environment("cellar", None)
    load_environment.cache_clear()
    assert (load_environment("cellar", None) == first).all()
    assert first.shape == (512, 1024, 3) and first.dtype == np.float32
    assert np.isfinite(first).all() and first.min() >= 0


@pytest.mark.parametrize(("side", "axis", "sign"), [("front", 1, 1), ("left", 0, -1)])
def test_a_window_is_where_its_side_says(side, axis, sign):
    window = WallPatch(side=side, at=(0.0, 1.15), size=(0.5, 0.5), colour="#ffffff", glow=9)
    room = Room(id="box", size=(4, 4, 3), walls="#808080", floor="#808080", patches=(window,))
    bright = paint_room(room)[..., 0] > 8
    towards = directions(bright.shape[0])[bright].mean(axis=0)
    assert sign * towards[axis] > 0.95
    # Seen from 2 m off, half a metre square: its solid angle is about 0.25 / 4.
    share = (bright * np.cos(np.linspace(np.pi / 2, -np.pi / 2, 512))[:, None]).sum() / 512 / 1024
    assert share * 2 * np.pi**2 == pytest.approx(0.25 / 4, rel=0.1)


def test_red_walls_light_the_room_red():
    lamp = WallPatch(side="ceiling", at=(0.0, 0.0), size=(0.5, 0.5), colour="#ffffff", glow=9)
    room = Room(id="red", size=(4, 4, 3), walls="#c02020", floor="#808080", patches=(lamp,))
    red, green, blue = paint_room(room)[400:].mean(axis=(0, 1))
    assert red > 1.15 * green and green == pytest.approx(blue, rel=0.05)


def test_an_unknown_environment_is_refused():
    with pytest.raises(UnknownName, match="moon_base"):
        load_environment("moon_base", None)
