"""What looking alone makes of Compare: the colours that show are those of the whole things."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from probe.assets.colour.difference import ciede2000
from probe.generation.first_look import FirstLook
from probe.generation.observer import Observer, marked, wanted_colour
from probe.tasks.task import Letter
from probe.tasks.type_rules import Form


def _answer(form: Form, question: str, options: Sequence[str], look: FirstLook) -> Letter:
    a, b = (np.array(thing.lab) for thing in marked(look))
    wanted = None if form == "darker" else wanted_colour(question, look)
    if wanted is None:
        return "A" if a[0] < b[0] else "B"
    return "A" if ciede2000(a, wanted) < ciede2000(b, wanted) else "B"


OBSERVER = Observer(_answer, by_colour=True)
