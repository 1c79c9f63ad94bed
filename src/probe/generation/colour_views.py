"""The colours of things in pictures: whole, in several lights, and of what shows of them."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from probe.assets.library import Library
from probe.generation.colour_cues import misfit, wanted
from probe.generation.palettes import shades
from probe.render.lighting import light_of
from probe.render.photograph import load_scene, photograph
from probe.render.renderer import Renderer
from probe.scene.lighting import Lighting, lighting_of
from probe.scene.scene import Scene
from probe.tasks.type_rules import Form
from probe.types import Array, Frame

OTHER_LIGHT = Lighting("workshop")
"""In which an answer must hold as well as in the scene's own light; it has a colour of its own."""


class ColourViews:
    """Pictures of a scene and of a few of its things; replaces what the renderer had loaded.

    Args:
        compared: Numbers of the things whose colours are compared; they lie apart.
    """

    def __init__(
        self,
        renderer: Renderer,
        scene: Scene,
        labels: Array,
        compared: Sequence[int],
        library: Library,
    ) -> None:
        load_scene(renderer, scene, library)
        lights = (lighting_of(scene.setup.lighting, scene.table), OTHER_LIGHT)
        self.lights = [light.name for light in lights]
        self._lit = {light.name: light_of(light, library.assets) for light in lights}
        self._renderer = renderer
        self._scene = scene
        self._labels = labels
        self._compared = compared
        self._bare: dict[str, Frame] = {}
        self._rgb: Array | None = None

    def main(self, number: int, light: str) -> Array:
        """Main colour of a thing where it is, with nothing on it, CIELAB, shape (3,)."""
        if light not in self._bare:
            bare = self._scene.only(*self._compared)
            self._bare[light] = photograph(self._renderer, bare, light=self._lit[light])
        frame = self._bare[light]
        assert frame.rgb is not None and frame.labels is not None
        return np.array(shades(frame.rgb[frame.labels == number])[0].lab)

    def patch(self, number: int) -> Array:
        """Main colour of what shows of a thing in the first light, CIELAB, shape (3,)."""
        if self._rgb is None:
            self._rgb = photograph(self._renderer, self._scene, light=self._lit[self.lights[0]]).rgb
        assert self._rgb is not None
        return np.array(shades(self._rgb[self._labels == number])[0].lab)

    def misfits(self, form: Form, marked: Sequence[int], subject: int | str) -> list[float]:
        """How far what shows of each marked thing is from what a question asks, in order.

        Args:
            form: Of the question.
            marked: Numbers of the things.
            subject: Number of the thing whose colour is asked for, else the colour's name or "".
        """
        if isinstance(subject, int):
            colour = wanted("", self.main(subject, self.lights[0]))
        else:
            colour = wanted(subject, None)
        return [float(misfit(form, self.patch(number), colour)) for number in marked]

    def lead(self, form: Form, marked: tuple[int, int], subject: int | str, right: int) -> float:
        """By how much better what shows of one of two things fits; see misfits().

        Args:
            form: Of the question.
            marked: Numbers of the two.
            subject: As in misfits().
            right: Index of the one.
        """
        misfits = self.misfits(form, marked, subject)
        return misfits[1 - right] - misfits[right]
