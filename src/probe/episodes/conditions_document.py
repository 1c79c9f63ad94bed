"""Conditions on disk, as a part of an episode's record."""

from __future__ import annotations

from typing import Literal

import pydantic

from probe.episodes.conditions import NO_DIALS, Conditions, Ideal, RendererKind, TableKind
from probe.perception.dials import Dials
from probe.scene.lighting import AMBIENT
from probe.scene.perturb import CameraName
from probe.scene.viewpoint import Viewpoint


class ConditionsDocument(pydantic.BaseModel, extra="forbid", allow_inf_nan=False):
    """In what an episode differs from its task.

    A task's own light is called "ambient" where it is even, as it was before there was another.
    """

    lighting: Literal["ambient", "own", "hdri"] = "ambient"
    camera: CameraName = "fixed"
    table: TableKind = "own"
    pose_jitter: float = 0.0
    dials: Dials = NO_DIALS
    ideal: Ideal = "none"
    # Left out where it is the usual one, as files of before there was a choice do.
    renderer: RendererKind = pydantic.Field(default="own", exclude_if=lambda it: it == "own")

    @staticmethod
    def of(conditions: Conditions, viewpoint: Viewpoint) -> ConditionsDocument:
        """The document of an episode's conditions, seen from its viewpoint."""
        even = conditions.lighting == "own" and viewpoint.lighting == AMBIENT
        return ConditionsDocument(
            lighting="ambient" if even else conditions.lighting,
            camera=conditions.camera,
            table=conditions.table,
            pose_jitter=conditions.pose_jitter,
            dials=conditions.dials,
            ideal=conditions.ideal,
            renderer=conditions.renderer,
        )

    def conditions(self) -> Conditions:
        """The conditions it describes."""
        return Conditions(
            lighting="hdri" if self.lighting == "hdri" else "own",
            camera=self.camera,
            table=self.table,
            pose_jitter=self.pose_jitter,
            dials=self.dials,
            ideal=self.ideal,
            renderer=self.renderer,
        )
