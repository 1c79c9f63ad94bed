"""What a recording says of verdicts on grasps, and the colours that it draws them in."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from probe.film.recording.stream import Colour
from probe.manipulation.candidates import Grasp
from probe.manipulation.verdicts import JudgedGrasp, Verdict


@dataclass(frozen=True)
class VerdictLook:
    """How a verdict is shown.

    Attributes:
        words: What it says.
        colour: Of the hands, sRGB.
        colour_name: What one calls that.
    """

    words: str
    colour: Colour
    colour_name: str


VERDICT_LOOKS: dict[Verdict, VerdictLook] = {
    "chosen": VerdictLook("chosen", (40, 230, 90), "green"),
    "untried": VerdictLook("fits, not tried", (90, 170, 255), "blue"),
    "spent": VerdictLook("like one that failed in this call", (170, 100, 255), "violet"),
    "no_way_out": VerdictLook("no way out to the basket", (255, 210, 60), "yellow"),
    "no_way_in": VerdictLook("no free route in", (255, 140, 30), "orange"),
    "out_of_reach": VerdictLook("no inverse kinematics", (255, 90, 200), "pink"),
    "touching": VerdictLook("hand would touch something", (150, 35, 35), "dark red"),
    "no_hold": VerdictLook("nothing to hold, or too wide", (105, 78, 55), "brown"),
    "unchecked": VerdictLook("not looked at", (95, 100, 105), "grey"),
}
"""All verdicts, the best first. Those that hundreds of hands have are dark."""


def counts_words(found: Sequence[JudgedGrasp]) -> str:
    """How many of each verdict, in a line."""
    counts = Counter(each.verdict for each in found)
    return "; ".join(
        f"{counts[verdict]} {look.words}"
        for verdict, look in VERDICT_LOOKS.items()
        if counts[verdict]
    )


def verdict_page(heading: str, found: Sequence[JudgedGrasp]) -> str:
    """The same as a table in Markdown, which is also a legend, and what was chosen."""
    counts = Counter(each.verdict for each in found)
    rows = [
        f"| {look.colour_name} | {counts[verdict]} | {look.words} |"
        for verdict, look in VERDICT_LOOKS.items()
    ]
    chosen = next((each.grasp for each in found if each.verdict == "chosen"), None)
    told = "Nothing was chosen." if chosen is None else f"Chosen: {grasp_words(chosen)}."
    table = "\n".join(["| hands | number | what became of them |", "|---|---|---|", *rows])
    return f"**{heading}.** {told}\n\n{table}\n"


def grasp_words(grasp: Grasp) -> str:
    """A grasp in a line."""
    sizes = f"width {1000 * grasp.width:.0f} mm, opening {1000 * grasp.opening:.0f} mm"
    how = ", by an edge" if grasp.by_edge else ""
    merit = f", merit {grasp.merit:.2f}" if np.isfinite(grasp.merit) else ""
    return f"{sizes}, tilt {np.degrees(grasp.tilt):.0f} degrees{merit}{how}"
