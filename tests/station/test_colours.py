"""Colours that are painted later: those of the moment of the look, and none where nobody asks."""

from collections.abc import Callable
from types import SimpleNamespace
from typing import cast

import numpy as np
import pytest

from boxes import box_library, standing, station_at
from probe.station.colours import coloured, in_colour, paintable
from probe.station.station import Station
from probe.types import Frame

LIBRARY = box_library(
    red_box=(0.08, 0.08, 0.05, 200, 30, 30), blue_box=(0.05, 0.05, 0.04, 30, 30, 200)
)
SCENE = standing(LIBRARY, ("red_box", 0.0, 0.0, 0.0), ("blue_box", 0.12, 0.0, 0.0))


@pytest.fixture
def station(renderer):
    return station_at(SCENE, LIBRARY, renderer)


@pytest.mark.parametrize("look", ["observe", "look_into_basket"])
def test_they_are_those_that_the_look_would_have_had(station, look):
    def seen(*, rgb: bool) -> Frame:
        return getattr(station, look)(rgb=rgb)

    plain, painted = seen(rgb=False), seen(rgb=True)
    station.take_away(1)
    assert (seen(rgb=True).rgb != painted.rgb).any()
    late = coloured(plain)
    assert (late.rgb == painted.rgb).all()
    assert (late.depth == painted.depth).all() and (late.labels == painted.labels).all()
    assert (late.shares, late.taken) == (painted.shares, painted.taken)


def test_simulation_paints_once_and_draws_nothing_again(station, renderer, monkeypatch):
    drawn: list[str] = []

    def noted(name: str) -> None:
        draw: Callable[..., object] = getattr(renderer, name)

        def ask(*words: object, **more: object) -> object:
            drawn.append(name)
            return draw(*words, **more)

        monkeypatch.setattr(renderer, name, ask)

    for name in ("draw", "paint", "labels", "outlines"):
        noted(name)
    plain = station.observe(rgb=False)
    drawn.clear()
    assert paintable(station, plain) is plain
    assert not drawn
    with_colours = in_colour(station, plain)
    assert drawn == ["paint"]
    assert in_colour(station, with_colours) is with_colours
    assert drawn == ["paint"]


def test_a_camera_takes_its_picture_while_the_table_stands_so():
    taken: list[bool] = []

    def observe(*, rgb: bool) -> Frame:
        taken.append(rgb)
        colours = np.zeros((2, 2, 3), np.uint8) if rgb else None
        return Frame(SCENE.setup.top.camera(2), np.ones((2, 2), np.float32), colours)

    camera = cast(Station, SimpleNamespace(observe=observe))
    held = paintable(camera, observe(rgb=False))
    assert taken == [False, True]
    assert coloured(held) is held
    assert in_colour(camera, held) is held
    assert taken == [False, True]


def test_a_look_without_colours_or_painter_is_refused():
    frame = Frame(SCENE.setup.top.camera(2), np.ones((2, 2), np.float32))
    with pytest.raises(ValueError, match="paintable"):
        coloured(frame)
