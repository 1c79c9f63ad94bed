"""What looking alone makes of Size: by what shows, the longer box or the larger area."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from probe.generation.first_look import FirstLook, VisibleThing
from probe.generation.observer import Observer, marked
from probe.tasks.task import Letter
from probe.tasks.type_rules import Form


def _answer(form: Form, question: str, options: Sequence[str], look: FirstLook) -> Letter:
    a, b = marked(look)
    one, other = (_diagonal(a), _diagonal(b)) if form == "longer" else (a.area_px, b.area_px)
    return "A" if (one > other) != (form == "smaller") else "B"


def _diagonal(thing: VisibleThing) -> float:
    left, top, right, bottom = thing.box_px
    return float(np.hypot(right - left, bottom - top))


OBSERVER = Observer(_answer)
