"""What can be made of a library, told before it is tried."""

from __future__ import annotations

from collections.abc import Sequence

from probe.assets.library import Library
from probe.cli.screen import ScreenTable, say
from probe.errors import ProbeError
from probe.generation.build_folder import TaskSlot
from probe.generation.feasibility import Feasibility

_SHOWN = 2


class Incomplete(ProbeError):
    """Some tasks that were asked for can't be made."""

    def __init__(self, written: str, left_out: Sequence[tuple[TaskSlot, str]]) -> None:
        question_types = dict.fromkeys(place.question_type for place, _ in left_out)
        lines = []
        for question_type in question_types:
            reasons = [why for place, why in left_out if place.question_type == question_type]
            lines.append(f"{len(reasons)} {question_type}: {reasons[0]}")
        super().__init__(
            f"{written} Left out: {'; '.join(lines)}. Ask for fewer, or add what is missing."
        )


def show_possible(found: Sequence[Feasibility], things: Library) -> None:
    """A table of types: how many tasks there are the things for, and what is missing."""
    if things.leading:
        mine = sum(map(things.leads, things.specs))
        say(f"{mine} things of your own play the parts in tasks; {len(things.specs) - mine} help.")
    table = ScreenTable("type", "asked", "castable", "missing", "what the type needs")
    for it in found:
        castable = len(it.places) - len(it.hopeless)
        missing = "\n".join(it.missing[:_SHOWN])
        table.add(it.question_type, str(len(it.places)), str(castable), missing, it.needs)
    table.show()
