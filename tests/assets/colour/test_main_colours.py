"""Draft colours as people say them."""

import numpy as np
import pytest

from probe.assets.colour.main_colours import said_colours
from probe.assets.mesh.lattice import colours_at, spots


@pytest.mark.parametrize(
    ("rgb", "name"),
    [
        ((200, 30, 30), "red"),
        ((20, 60, 160), "blue"),
        ((240, 240, 240), "white"),
        ((15, 15, 15), "black"),
        ((120, 122, 121), "gray"),
        ((250, 210, 50), "yellow"),
        ((240, 130, 30), "orange"),
        # Dull ones, which plain distance calls gray.
        ((120, 100, 80), "brown"),
        ((95, 108, 85), "green"),
        ((100, 105, 138), "blue"),
    ],
)
def test_patches(rgb, name):
    assert said_colours(np.full((50, 3), rgb, np.uint8)) == (name,)


def test_a_second_colour_counts_from_a_third_or_so():
    red, white = np.full((600, 3), (190, 30, 30)), np.full((400, 3), (240, 240, 240))
    assert said_colours(np.concatenate([red, white]).astype(np.uint8)) == ("red", "white")
    assert said_colours(np.concatenate([red, white[:100]]).astype(np.uint8)) == ("red",)


WORDS = {
    "silver": {"gray"}, "tan": {"beige", "brown"}, "gold": {"yellow", "brown"},
    "light gray": {"gray", "white"}, "dark gray": {"gray", "black"},
    "light brown": {"brown", "beige"},
}  # fmt: skip


@pytest.mark.slow
def test_nine_in_ten_scans_are_called_by_a_colour_that_people_see(assets):
    from probe.assets.gltf.glb import load_glb
    from probe.assets.pools.scan_catalogue import scan_rows

    rows, agreed = scan_rows(), 0
    for row in rows:
        mesh = load_glb(assets / "scans" / f"{row.id}.glb")
        pixels = colours_at(mesh, *spots(mesh.vertices, mesh.faces, 4000))
        seen = [WORDS.get(word) or {word.split()[-1]} for word in row.colours]
        agreed += any(said_colours(pixels)[0] in words for words in seen)
    assert agreed >= 0.9 * len(rows)
