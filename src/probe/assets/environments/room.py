"""Indoor rooms as data: walls, lights and furniture that a painter turns into a panorama."""

from __future__ import annotations

from functools import cache
from importlib.resources import files
from typing import Annotated, Literal

import yaml
from pydantic import BaseModel, ConfigDict, Field, TypeAdapter, ValidationError

from probe.errors import BadData
from probe.files import fault

Side = Literal["front", "right", "back", "left", "floor", "ceiling"]
SIDES: tuple[Side, ...] = ("front", "right", "back", "left", "floor", "ceiling")
Colour = Annotated[str, Field(pattern=r"^#[0-9a-f]{6}$")]


class _Data(BaseModel):
    model_config = ConfigDict(frozen=True, extra="forbid")


class WallPatch(_Data):
    """A rectangle on one side of the room: a window, a lamp, a door, a picture.

    Attributes:
        side: Front is where the panorama's middle is.
        at: Its middle in metres: on a wall to the right of the wall's middle and above the floor;
            on floor and ceiling along x and y.
        size: Metres.
        colour: sRGB.
        glow: Radiance of a light, times its colour; 0 for what only reflects.
        frame: Width of a frame around it, metres.
        panes: How many panes side by side and one above the other.
    """

    side: Side
    at: tuple[float, float]
    size: tuple[float, float]
    colour: Colour
    glow: float = Field(default=0.0, ge=0)
    frame: float = Field(default=0.0, ge=0)
    frame_colour: Colour = "#e8e6e0"
    panes: tuple[int, int] = (1, 1)


class Furniture(_Data):
    """A box, from one corner to the other; metres from the middle of the floor.

    Attributes:
        round: Whether it is the ball, stretched, that just fits into the box.
    """

    low: tuple[float, float, float]
    high: tuple[float, float, float]
    colour: Colour
    round: bool = False


class Room(_Data):
    """A room around a table in its middle.

    Attributes:
        size: Metres along x and y, and its height.
        eye: Height of the panorama's middle above the floor: just over the table.
        stand: Where that is, along x and y from the middle of the floor.
        walls: One colour, or four: front, right, back, left.
        pattern: What the floor is laid with, and how wide in metres.
        shading: Boxes that keep even light from floor and walls near them.
    """

    id: str = Field(pattern=r"^[a-z0-9_]+$")
    size: tuple[float, float, float]
    eye: float = 1.15
    stand: tuple[float, float] = (0.0, 0.0)
    walls: Colour | tuple[Colour, Colour, Colour, Colour]
    ceiling: Colour = "#f2f0ea"
    floor: Colour
    pattern: tuple[Literal["plain", "planks", "tiles"], float] = ("plain", 1.0)
    patches: tuple[WallPatch, ...]
    boxes: tuple[Furniture, ...] = ()
    shading: tuple[Furniture, ...] = ()

    @property
    def colours(self) -> tuple[Colour, ...]:
        """Of all sides, in the order of SIDES."""
        walls = (self.walls,) * 4 if isinstance(self.walls, str) else self.walls
        return (*walls, self.floor, self.ceiling)


@cache
def rooms() -> dict[str, Room]:
    """All rooms by id.

    Raises:
        BadData: The file breaks its schema.
    """
    text = (files("probe.assets.environments") / "rooms.yaml").read_text("utf-8")
    try:
        found = TypeAdapter(list[Room]).validate_python(yaml.load(text, yaml.CSafeLoader))
    except ValidationError as error:
        raise BadData("rooms.yaml", fault(error, "the file"), "Correct it.") from error
    return {room.id: room for room in found}
