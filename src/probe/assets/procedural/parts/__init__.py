"""The parts that objects are put together from, as data that can build itself."""

from typing import Annotated

from pydantic import Field

from probe.assets.procedural.parts.ball import Ball
from probe.assets.procedural.parts.box import RoundedBox
from probe.assets.procedural.parts.hollow import Hollow
from probe.assets.procedural.parts.part import Painted, Triple
from probe.assets.procedural.parts.swept import Swept
from probe.assets.procedural.parts.turned import Turned

Part = Annotated[Turned | Hollow | Swept | RoundedBox | Ball, Field(discriminator="kind")]

__all__ = ["Painted", "Part", "Triple"]
