"""Paints as the second version of looks has them: finer grain, weaker figures."""

from __future__ import annotations

from probe.assets.procedural.paint.data import Paint
from probe.assets.procedural.paint.materials import Metal, Weave, Wood
from probe.assets.procedural.paint.mottled import Blotch, Mottled


def refined(paint: Paint) -> Paint:
    """The paint with its figure at the scale and strength of the real thing.

    Year rings of small things are 1 to 3 mm apart. Grain at the scale of single pixels looks like
    the noise of a cheap camera wherever it is strong.
    """
    if isinstance(paint, Wood):
        return paint.model_copy(
            update={"ring": 0.32 * paint.ring, "contrast": 0.55 * paint.contrast}
        )
    if isinstance(paint, Metal):
        return paint.model_copy(update={"brush": 0.5 * paint.brush})
    if isinstance(paint, Weave):
        return paint.model_copy(update={"uneven": 0.6 * paint.uneven})
    if isinstance(paint, Mottled):
        layers = tuple(_calmer(it) if isinstance(it, Blotch) else it for it in paint.layers)
        return paint.model_copy(update={"grain": 0.4 * paint.grain, "layers": layers})
    return paint


def _calmer(blotch: Blotch) -> Blotch:
    """Tiny blotches at half strength: those of one scale all over are what gives paint away."""
    fine = blotch.cell < 0.002
    return blotch.model_copy(update={"strength": 0.5 * blotch.strength}) if fine else blotch
