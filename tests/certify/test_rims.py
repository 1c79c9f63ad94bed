"""Which colours show at the rims of things."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np

from probe.assets.mesh import Surface, TexturedMesh
from probe.certify.rims import Rims, sides
from tabletops import spec


class Shelf:
    """A library of one box, white where x < 0 and black elsewhere, but for a red underside."""

    def __init__(self, size):
        self.size = size

    def __getitem__(self, _):
        return SimpleNamespace(size=self.size)

    def body(self, _):
        return SimpleNamespace(mesh=box(self.size))


def box(size) -> TexturedMesh:
    """Two halves side by side; texture columns: white, black, red."""
    x, y, z = size
    corners, faces, uvs = [], [], []
    for left, right, column in ((-x / 2, 0, 0), (0, x / 2, 1)):
        for height, u in ((z, column), (0, 2)):
            first = len(corners)
            corners += [(a, b, height) for a in (left, right) for b in (-y / 2, y / 2)]
            uvs += [((u + 0.5) / 3, 0.5)] * 4
            faces += [(first, first + 1, first + 2), (first + 1, first + 3, first + 2)]
    texture = np.array([[(250, 250, 250), (5, 5, 5), (220, 20, 20)]], np.uint8)
    return TexturedMesh(
        np.array(corners, np.float32),
        np.tile(np.array([[0, 0, 1]], np.float32), (len(corners), 1)),
        np.array(uvs, np.float32),
        np.array(faces, np.int32),
        Surface(texture),
    )


def shown(shelf: Shelf) -> np.ndarray:
    """CIELAB of all sides of the box."""
    return np.array([side.lab for side in sides(shelf, "box")])  # type: ignore[arg-type]


def test_each_side_shows_its_own_colour_and_the_underside_none():
    found = shown(Shelf((0.1, 0.1, 0.05)))
    assert len(found) >= 8
    bright, dark = found[:, 0] > 90, found[:, 0] < 10
    assert bright.sum() >= 4 and dark.sum() >= 4 and (bright | dark).all()


def test_what_is_taller_than_wide_shows_the_side_on_which_it_does_not_lie():
    # Laid over about y, its white half comes to lie above the black one.
    found = shown(Shelf((0.04, 0.08, 0.12)))
    assert (found[:, 0] > 90).any() and not (found[:, 0] < 10).any()


def test_rims_of_things_are_dimmer_than_their_textures():
    """What shows beside covers; the box is as much white as black, and which one is its main."""
    shelf, things = Shelf((0.1, 0.1, 0.05)), [spec("box", "white"), spec("case", "black")]
    rims = Rims.of(shelf, things)  # type: ignore[arg-type]
    assert rims.specs == tuple(things)
    assert set(rims.owner) == {0, 1} and len(rims.owner) == len(rims.colours) >= 16
    assert 70 < rims.colours[:, 0].max() < 85, "white, in half the light"
    assert list(rims.odd()) == [0, 1]
    nothing = Rims.of(shelf, [])  # type: ignore[arg-type]
    assert nothing.main.shape == nothing.colours.shape == (0, 3)


def test_sides_face_where_they_lie():
    for side in sides(Shelf((0.1, 0.1, 0.05)), "box"):  # type: ignore[arg-type]
        if abs(np.cos(side.angle)) > 0.5:
            assert (side.lab[0] > 90) == (np.cos(side.angle) < 0), "white where x < 0"
