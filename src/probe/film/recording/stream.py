"""A recording under way, in values of ours. Nothing else in the project knows Rerun but the layout.

What is told stands at a moment on two timelines: simulated time, and the number of the call.
"""

from __future__ import annotations

import uuid
from collections.abc import Sequence
from importlib import import_module
from importlib.util import find_spec
from typing import Any, Literal

import numpy as np
from PIL import Image

from probe.assets.mesh.mesh import TexturedMesh
from probe.errors import BadData, MissingExtra
from probe.files import encode
from probe.types import Array, Pose

TIME, STEP = "time", "step"
"""Names of the timelines."""

_TEXTURE_PX = 512
"""Width of textures at most; in full size they would be four fifths of a recording."""

Colour = tuple[int, int, int]
Level = Literal["INFO", "WARN", "ERROR"]


def require_rerun() -> Any:
    """Rerun's library.

    Raises:
        MissingExtra: It isn't installed.
        BadData: The environment turns it off.
    """
    if find_spec("rerun") is None:
        raise MissingExtra("Writing recordings for Rerun", "rerun")
    rerun: Any = import_module("rerun")
    if not rerun.is_enabled(rerun.RecordingStream("probe")):
        raise BadData("RERUN", "turns all recordings off", "Unset this variable of the environment")
    return rerun


class RecordingWriter:
    """Takes values and gives a file's bytes.

    Args:
        name: What the viewer calls it.
        layout: A blueprint of Rerun's; see probe.film.recording.layout.
    """

    def __init__(self, name: str, layout: Any) -> None:
        self._rr = require_rerun()
        # The viewer takes two of one identity for parts of the same recording and mixes them.
        self._stream = self._rr.RecordingStream(
            "probe", recording_id=uuid.uuid4(), send_properties=False
        )
        self._stream.set_log_time_enabled(False)
        self._stream.set_log_tick_enabled(False)
        self._bytes = self._stream.binary_stream()
        self._stream.send_blueprint(layout)
        self._stream.send_recording_name(name)
        self._log("world", self._rr.ViewCoordinates.RIGHT_HAND_Z_UP, static=True)

    def content(self) -> bytes:
        """All of it, as a file has it; nothing can be added afterwards."""
        return self._bytes.read()

    def at(self, seconds: float, step: int) -> None:
        """What is told from now on happens then."""
        self._stream.set_time(TIME, duration=seconds)
        self._stream.set_time(STEP, sequence=step)

    def clear(self, entity: str) -> None:
        """Nothing that was told of an entity, and of those below it, holds any longer."""
        self._log(entity, self._rr.Clear(recursive=True))

    def body(self, entity: str, mesh: TexturedMesh, colours: Array | None = None) -> None:
        """The look of something, always the same.

        Args:
            entity: It.
            mesh: Its shape and texture.
            colours: Of its vertices in place of the texture, uint8, shape (n, 3).
        """
        textured = colours is None
        image = Image.fromarray(mesh.surface.texture)
        small = np.asarray(image.reduce(max(1, image.width // _TEXTURE_PX)))
        archetype = self._rr.Mesh3D(
            vertex_positions=mesh.vertices,
            triangle_indices=mesh.faces,
            vertex_normals=mesh.normals,
            vertex_colors=colours,
            vertex_texcoords=mesh.uvs if textured else None,
            albedo_texture=small if textured else None,
        )
        self._log(entity, archetype, static=True)

    def motion(self, entity: str, seconds: Sequence[float], poses: Sequence[Pose]) -> None:
        """How something moves in time; the other timeline knows nothing of it."""
        self._columns(entity, self._rr.TimeColumn(TIME, duration=seconds), poses)

    def places(self, entity: str, steps: Sequence[int], poses: Sequence[Pose]) -> None:
        """Where something is when each call is made; time knows nothing of it."""
        self._columns(entity, self._rr.TimeColumn(STEP, sequence=steps), poses)

    def points(self, entity: str, points: Array, colours: Array | Colour, radius: float) -> None:
        """Points, world, metres, shape (n, 3), with a colour each or one for all."""
        self._log(entity, self._rr.Points3D(points, colors=colours, radii=radius))

    def lines(
        self,
        entity: str,
        strips: Sequence[Array],
        colours: Sequence[Colour] | Colour,
        radius: float,
        labels: Sequence[str] = (),
    ) -> None:
        """Polylines, world, metres, each of shape (k, 3); their labels show when selected."""
        archetype = self._rr.LineStrips3D(
            strips, colors=colours, radii=radius, labels=labels or None, show_labels=False
        )
        self._log(entity, archetype)

    def picture(self, entity: str, picture: Array) -> None:
        """A picture, uint8, shape (h, w, 3), kept without loss."""
        content = encode(Image.fromarray(picture), "PNG")
        self._log(entity, self._rr.EncodedImage(contents=content, media_type="image/png"))

    def regions(self, entity: str, numbers: Array, names: Sequence[str]) -> None:
        """Which region each pixel is in, shape (h, w): 0 for none, else from 1 in the names."""
        classes = [(number, name) for number, name in enumerate(names, start=1)]
        self._log(entity, self._rr.AnnotationContext([(0, "", (0, 0, 0, 0)), *classes]))
        archetype = self._rr.SegmentationImage(numbers.astype(np.uint16), opacity=0.55)
        self._log(entity, archetype)

    def text(self, text: str, level: Level = "INFO") -> None:
        """A line, or several, of the log: one entity, for only then does the viewer keep order."""
        self._log("log", self._rr.TextLog(text, level=level))

    def page(self, entity: str, markdown: str) -> None:
        """A page of text that stands until the next one."""
        self._log(entity, self._rr.TextDocument(markdown, media_type="text/markdown"))

    def _columns(self, entity: str, index: Any, poses: Sequence[Pose]) -> None:
        columns = self._rr.Transform3D.columns(
            translation=[pose.position for pose in poses],
            quaternion=[(*pose.wxyz[1:], pose.wxyz[0]) for pose in poses],
        )
        self._stream.send_columns(entity, indexes=[index], columns=columns, strict=True)

    def _log(self, entity: str, archetype: Any, *, static: bool = False) -> None:
        self._stream.log(entity, archetype, static=static, strict=True)
