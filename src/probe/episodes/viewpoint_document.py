"""What an episode's camera saw by, on disk, as a part of its record."""

from __future__ import annotations

import pydantic

from probe.scene.lighting import Lighting
from probe.scene.pose_document import Position, Rotation
from probe.scene.setup import UR5_TABLE, RendererName
from probe.scene.setup_file import MOST_PX
from probe.scene.viewpoint import Viewpoint
from probe.types import Camera, Pose


class ViewpointDocument(pydantic.BaseModel, extra="forbid", allow_inf_nan=False):
    """Pose of the camera (world_from_camera), light and renderer, if they weren't the usual ones.

    Field of view and size of the pictures are left out where they are those of the usual camera.
    """

    position: Position
    wxyz: Rotation
    lighting: str
    yaw: float
    fov_deg: float | None = pydantic.Field(
        default=None, gt=0, lt=180, exclude_if=lambda it: it is None
    )
    picture_px: int | None = pydantic.Field(
        default=None, ge=1, le=MOST_PX, exclude_if=lambda it: it is None
    )

    renderer: RendererName = pydantic.Field(
        default="filament", exclude_if=lambda it: it == "filament"
    )

    @staticmethod
    def of(viewpoint: Viewpoint) -> ViewpointDocument | None:
        """The document of a viewpoint; None for the usual one."""
        if viewpoint == Viewpoint():
            return None
        camera, light = viewpoint.camera, viewpoint.lighting
        usual, pose = UR5_TABLE.camera(), camera.world_from_camera
        return ViewpointDocument(
            position=pose.position,
            wxyz=pose.wxyz,
            lighting=light.name,
            yaw=light.yaw,
            fov_deg=None if camera.fov_y_deg == usual.fov_y_deg else camera.fov_y_deg,
            picture_px=None if camera.width_px == usual.width_px else camera.width_px,
            renderer=viewpoint.renderer,
        )

    def viewpoint(self) -> Viewpoint:
        """The viewpoint it describes."""
        usual = UR5_TABLE.camera()
        size = self.picture_px or usual.width_px
        camera = Camera(Pose(self.position, self.wxyz), size, size, self.fov_deg or usual.fov_y_deg)
        return Viewpoint(camera, Lighting(self.lighting, self.yaw), self.renderer)
