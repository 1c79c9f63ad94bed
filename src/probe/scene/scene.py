"""The table as data: what stands on it, and where. No physics, no pixels."""

from __future__ import annotations

from dataclasses import dataclass, replace

from probe.scene.setup import UR5_TABLE, Setup
from probe.types import Pose


@dataclass(frozen=True)
class PlacedObject:
    """One object on the table.

    Attributes:
        instance: Number of this object in its scene, from 1; labels carry it.
        object_id: Which object of the library it is.
        pose: world_from_object, metres.
    """

    instance: int
    object_id: str
    pose: Pose


@dataclass(frozen=True)
class Scene:
    """A settled table.

    Attributes:
        seed: The seed it was made from; a private task's scene bears the task's.
        table: Id of the table's material.
        objects: In order of their instance numbers.
        setup: What stands around them, and what they are seen by.
    """

    seed: int
    table: str
    objects: tuple[PlacedObject, ...]
    setup: Setup = UR5_TABLE

    def without(self, *instances: int) -> Scene:
        """The same table with some objects taken away, nothing else moved (ghost removal)."""
        kept = tuple(o for o in self.objects if o.instance not in instances)
        return replace(self, objects=kept)

    def only(self, *instances: int) -> Scene:
        """The same table with these objects alone."""
        return replace(self, objects=tuple(o for o in self.objects if o.instance in instances))

    def like(self, instance: int) -> tuple[int, ...]:
        """Instances of the same object as this one, itself among them."""
        wanted = self[instance].object_id
        return tuple(o.instance for o in self.objects if o.object_id == wanted)

    def __getitem__(self, instance: int) -> PlacedObject:
        return next(o for o in self.objects if o.instance == instance)
