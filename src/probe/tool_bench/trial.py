"""One attempt of one tool on one true target, as it is kept on disk."""

from __future__ import annotations

from typing import Literal

from pydantic import BaseModel, ConfigDict

Tool = Literal["grasp", "push"]


class ToolTrial(BaseModel):
    """What was tried and what the simulator says of it; lengths in metres, times in CPU seconds.

    Attributes:
        good: A grasp: the object is in the basket. A push: it went at least half of the distance
            asked for that way.
        executed: A grasp: it was carried out to the end, by the skill's own word. A push: the
            tool, or by its looks the thing, went as far as asked, less 1 cm.
        truthful: What the skill said of the basket agrees with where the object is.
        others_moved: Other objects that ended more than 3 cm from where they were.
        others_lost: Of those, how many ended off the table.
        ratio: Way of the pushed object over the distance asked for.
        width: Planned distance of the pads of the last grasp; 0 without one.
        share: Visible share of the target beforehand.
        planning, execution: CPU seconds of this process outside and inside station calls.
        restless: How many draws of the table before this one weren't at rest; None in files from
            before that was checked.
        shoved: A grasp: whether the thing was pushed first; None for pushes, and in files of before
            grasps did that.
    """

    model_config = ConfigDict(frozen=True, extra="forbid", allow_inf_nan=False)

    tool: Tool
    seed: int
    instance: int
    object_id: str
    direction: str | None
    distance: float | None
    status: str
    good: bool
    executed: bool
    truthful: bool
    others_moved: int
    others_lost: int
    ratio: float | None
    tries: int
    width: float
    share: float
    mass: float
    longest: float
    planning: float
    execution: float
    restless: int | None = None
    shoved: bool | None = None

    @property
    def cause(self) -> str:
        """The outcome in a word or two, said as it was told, and corrected where it was wrong."""
        if self.tool == "push":
            return self.status if self.good or self.status != "pushed" else "pushed, hardly moved"
        where = "in the basket" if self.good else "not in the basket"
        return self.status if self.truthful else f"{self.status} but {where}"

    @property
    def groups(self) -> tuple[tuple[str, str], ...]:
        """Classes it belongs to: what is told apart, and which class."""
        seen = "all" if self.share > 0.95 else "over 60 %" if self.share > 0.6 else "30 to 60 %"
        common = (
            ("longest side", band(self.longest, 0.08, 0.16)),
            ("visible", seen),
            ("mass", "over 0.3 kg" if self.mass > 0.3 else "up to 0.3 kg"),
        )
        if self.tool == "grasp":
            wide = band(self.width, 0.03, 0.06, 0.09) if self.tries else "no grasp found"
            pushed = (
                () if self.shoved is None else (("pushed first", "yes" if self.shoved else "no"),)
            )
            executed = ("grasps executed", str(self.tries))
            return (*common, ("grasp width", wide), executed, *pushed)
        assert self.direction is not None and self.distance is not None
        return (*common, ("direction", self.direction), ("asked", band(self.distance, 0.08, 0.14)))


def band(value: float, *edges: float) -> str:
    """Which of the classes between some edges, metres, a value lies in; in centimetres."""
    above = [edge for edge in edges if value > edge]
    below = [edge for edge in edges if value <= edge]
    low = f"{100 * above[-1]:.0f}" if above else "0"
    return f"{low}-{100 * below[0]:.0f} cm" if below else f"over {low} cm"
