"""What is said between a client and a render worker: plain values, no engine types."""

from __future__ import annotations

from dataclasses import dataclass

from probe.assets.mesh.mesh import Material, TexturedMesh
from probe.render.illumination import Illumination
from probe.scene.scene import PlacedObject
from probe.types import Array, Camera


@dataclass(frozen=True, eq=False)
class TableTop:
    """The table as it is drawn.

    Attributes:
        surface: Texture and material.
        tile_size: Metres of table that one repeat of the texture covers.
        extent: Size along x and y in metres.
    """

    surface: Material
    tile_size: float
    extent: tuple[float, float]


@dataclass(frozen=True, eq=False)
class Load:
    """Keep these meshes by object id; replaces whatever was loaded before."""

    meshes: dict[str, TexturedMesh]
    table: TableTop


@dataclass(frozen=True, eq=False)
class DrawRequest:
    """Draw the loaded objects at these poses; the answer is a Drawn.

    Attributes:
        light: What falls on them, where a colour picture is wanted; None where it isn't.
        grainless: Whether Blender is to take its time, so that shadows show no grain.
    """

    objects: tuple[PlacedObject, ...]
    camera: Camera
    light: Illumination | None
    grainless: bool = False


@dataclass(frozen=True, eq=False)
class DrawColours:
    """Draw the loaded objects' colours alone; the answer is Pictures of one."""

    objects: tuple[PlacedObject, ...]
    camera: Camera
    light: Illumination


@dataclass(frozen=True, eq=False)
class DrawSeries:
    """Draw colour pictures of several moments; the answers are Pictures of one each.

    Attributes:
        moments: What stands where in each, in the order of drawing.
        light: What falls on it.
        far: How far the camera sees, metres.
    """

    moments: tuple[tuple[PlacedObject, ...], ...]
    camera: Camera
    light: Illumination
    far: float

    @property
    def objects(self) -> tuple[PlacedObject, ...]:
        """All that stands in any of them."""
        return tuple(placed for moment in self.moments for placed in moment)


@dataclass(frozen=True)
class Label:
    """Draw the loaded objects' numbers alone; the answer is Labels."""

    objects: tuple[PlacedObject, ...]
    camera: Camera


@dataclass(frozen=True)
class Outline:
    """Draw each object as if it stood there alone; the answer is Outlines."""

    objects: tuple[PlacedObject, ...]
    camera: Camera


@dataclass(frozen=True, eq=False)
class DrawReply:
    """Arrays of a Frame: depth (h, w) float32 metres, labels (h, w) int32, rgb or None."""

    depth: Array
    labels: Array
    rgb: Array | None


@dataclass(frozen=True, eq=False)
class Labels:
    """Instance numbers, int32, shape (h, w); 0 where no object is."""

    numbers: Array


@dataclass(frozen=True, eq=False)
class Outlines:
    """Masks by instance, bool, shape (h, w), of each object standing alone."""

    masks: dict[int, Array]


@dataclass(frozen=True, eq=False)
class Pictures:
    """Colour pictures, uint8, each of shape (h, w, 3)."""

    rgb: tuple[Array, ...]


Request = Load | DrawRequest | DrawColours | DrawSeries | Label | Outline
Answer = DrawReply | Labels | Outlines | Pictures | None
