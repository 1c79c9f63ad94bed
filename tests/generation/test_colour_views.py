"""Colours of things with nothing on them, as the pictures show them."""

from __future__ import annotations

import numpy as np
import pytest

from probe.assets.library import Library
from probe.generation.colour_views import OTHER_LIGHT, ColourViews
from probe.render.renderer import Renderer
from probe.scene.lighting import AMBIENT
from probe.scene.scene import PlacedObject, Scene
from probe.types import Pose

APART = Scene(
    1,
    "walnut",
    (
        PlacedObject(1, "proc_red_mug", Pose((-0.15, 0.0, 0.0))),
        PlacedObject(2, "proc_green_soap", Pose((0.15, 0.0, 0.0))),
        PlacedObject(3, "proc_black_key", Pose((0.15, 0.0, 0.12))),
    ),
)


@pytest.mark.slow
def test_what_is_compared_looks_as_it_does_alone(library: Library, renderer: Renderer):
    labels = np.zeros((1, 1), int)
    both = ColourViews(renderer, APART, labels, (1, 2), library)
    lights = (AMBIENT, OTHER_LIGHT)
    together = {(n, li.name): both.main(n, li.name) for n in (1, 2) for li in lights}
    for number in (1, 2):
        alone = ColourViews(renderer, APART, labels, (number,), library)
        for light in lights:
            colour = alone.main(number, light.name)
            assert np.abs(colour - together[number, light.name]).max() < 0.5, (number, light.name)
    mug, soap = (together[n, "ambient"] for n in (1, 2))
    assert soap[1] < -10 < mug[1], "soap is green; CIELAB's a tells"
