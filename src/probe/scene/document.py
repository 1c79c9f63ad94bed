"""A Scene on disk: versioned JSON, checked when it is read."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Literal

import pydantic

from probe.files import read_document, write_text
from probe.scene.pose_document import Position, Rotation
from probe.scene.scene import PlacedObject, Scene
from probe.scene.setup import UR5_TABLE
from probe.scene.setup_file import SetupDocument
from probe.types import Pose


class PlacedObjectDocument(pydantic.BaseModel, extra="forbid", allow_inf_nan=False):
    """One object: world_from_object in metres, rotation wxyz."""

    instance: int = pydantic.Field(ge=1)
    object_id: str
    position: Position
    wxyz: Rotation


class SceneDocument(pydantic.BaseModel, extra="forbid"):
    """The whole table."""

    version: Literal[1] = 1
    seed: int = pydantic.Field(ge=0)
    table: str
    objects: Annotated[list[PlacedObjectDocument], pydantic.FailFast()]
    # Left out where it is the usual one, as files of before there were others do.
    setup: SetupDocument | None = pydantic.Field(default=None, exclude_if=lambda it: it is None)

    @pydantic.model_validator(mode="after")
    def _each_once(self) -> SceneDocument:
        numbers = [placed.instance for placed in self.objects]
        twice = sorted({number for number in numbers if numbers.count(number) > 1})
        if twice:
            raise ValueError(f"instance {twice[0]} is there twice")
        return self

    @staticmethod
    def of(scene: Scene) -> SceneDocument:
        """The document of a scene."""
        objects = [
            PlacedObjectDocument(
                instance=item.instance,
                object_id=item.object_id,
                position=item.pose.position,
                wxyz=item.pose.wxyz,
            )
            for item in scene.objects
        ]
        setup = None if scene.setup == UR5_TABLE else SetupDocument.of(scene.setup)
        return SceneDocument(seed=scene.seed, table=scene.table, objects=objects, setup=setup)

    def scene(self) -> Scene:
        """The scene it describes."""
        objects = tuple(
            PlacedObject(item.instance, item.object_id, Pose(item.position, item.wxyz))
            for item in self.objects
        )
        setup = self.setup.setup() if self.setup else UR5_TABLE
        return Scene(self.seed, self.table, objects, setup)


def write_scene(path: Path, scene: Scene) -> None:
    """Write a scene as JSON; floats keep every bit."""
    write_text(path, SceneDocument.of(scene).model_dump_json(indent=1) + "\n")


def read_scene(path: Path) -> Scene:
    """Read a scene that write_scene wrote.

    Raises:
        BadData: The file is missing, truncated or not a scene of this version.
    """
    return read_document(path, SceneDocument, "Write it again with `probe scene`").scene()
