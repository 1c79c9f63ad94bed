"""The caller's side of a render worker: load once, draw many times, survive its death once."""

from __future__ import annotations

import tempfile
from collections.abc import Mapping, Sequence
from pathlib import Path
from types import TracebackType
from typing import cast

from probe.assets.mesh.mesh import TexturedMesh
from probe.errors import RenderFailed
from probe.processes.starting import start_module
from probe.processes.worker_process import WorkerSilent
from probe.render.driver import require_blender, require_driver
from probe.render.illumination import AMBIENT, Illumination
from probe.render.protocol import (
    Answer,
    DrawColours,
    DrawReply,
    DrawRequest,
    DrawSeries,
    Label,
    Labels,
    Load,
    Outline,
    Outlines,
    Pictures,
    Request,
    TableTop,
)
from probe.scene.scene import PlacedObject
from probe.scene.setup import RendererName
from probe.types import Array, Camera, Frame

TIMEOUTS: dict[RendererName, float] = {"filament": 120.0, "blender": 900.0}
"""Seconds after which a silent worker counts as dead; a cold shader cache takes Filament about 10,
Blender up to 50, and one picture of Blender's 30 on two idle cores without GPU."""


class Renderer:
    """Draws scenes in a worker process. Use it as a context manager, or call close().

    The bytes of a frame depend only on what is loaded, where it stands, the camera and the light;
    never on what was drawn before.

    Args:
        cache: Folder in which light prepared for drawing is kept; None to prepare it each time.
        engine: What draws colour. Depth and labels are Filament's either way.

    Raises:
        NoGraphicsDriver: On construction, when the machine has no Vulkan driver, or no EGL for
            Blender.
        MissingExtra: Blender isn't installed.
    """

    def __init__(self, cache: Path | None = None, engine: RendererName = "filament") -> None:
        require_driver()
        if engine == "blender":
            require_blender()
        self._cache = cache
        self._engine: RendererName = engine
        self._load: Load | None = None
        self._worker: _Worker | None = None

    def __enter__(self) -> Renderer:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close()

    def close(self) -> None:
        """End the worker."""
        if self._worker:
            self._worker.stop()
        self._worker = None

    @property
    def name(self) -> RendererName:
        """What draws colour."""
        return self._engine

    @property
    def pid(self) -> int | None:
        """Process id of the worker, if one is running."""
        return self._worker.pid if self._worker else None

    def load(self, meshes: Mapping[str, TexturedMesh], table: TableTop) -> None:
        """Hand over the objects that pictures may show, by object id; replaces earlier ones."""
        self._load = Load(dict(meshes), table)
        if self._worker:
            self._ask(self._load)

    def draw(
        self,
        objects: Sequence[PlacedObject],
        camera: Camera,
        *,
        rgb: bool,
        light: Illumination = AMBIENT,
        grainless: bool = False,
    ) -> Frame:
        """Depth and labels of loaded objects at their poses, and a picture if wanted.

        Args:
            objects: What stands where.
            camera: From where.
            rgb: Whether a colour picture is wanted.
            light: What falls on it.
            grainless: Whether Blender takes three times as long, so that shadows show no grain.
                Filament's show none in any case.

        Raises:
            RenderFailed: The worker died twice on this request.
            ValueError: An object isn't loaded.
        """
        lit = light if rgb else None
        answer = self._ask_of(DrawRequest(tuple(objects), camera, lit, grainless))
        assert isinstance(answer, DrawReply)
        return Frame(camera, answer.depth, answer.rgb, answer.labels)

    def paint(
        self, objects: Sequence[PlacedObject], camera: Camera, light: Illumination = AMBIENT
    ) -> Array:
        """The picture of loaded objects, uint8, shape (h, w, 3), as draw() has it; sooner.

        Raises:
            RenderFailed: The worker died twice on this request.
            ValueError: An object isn't loaded.
        """
        answer = self._ask_of(DrawColours(tuple(objects), camera, light))
        assert isinstance(answer, Pictures)
        return answer.rgb[0]

    def labels(self, objects: Sequence[PlacedObject], camera: Camera) -> Array:
        """Instance numbers of loaded objects, int32, shape (h, w), as draw() has them; sooner.

        Raises:
            RenderFailed: The worker died twice on this request.
        """
        answer = self._ask_of(Label(tuple(objects), camera))
        assert isinstance(answer, Labels)
        return answer.numbers

    def outlines(self, objects: Sequence[PlacedObject], camera: Camera) -> dict[int, Array]:
        """Mask, bool (h, w), of each object as if it stood there alone, by instance."""
        answer = self._ask_of(Outline(tuple(objects), camera))
        assert isinstance(answer, Outlines)
        return answer.masks

    def series(
        self,
        moments: Sequence[Sequence[PlacedObject]],
        camera: Camera,
        light: Illumination,
        far: float,
    ) -> tuple[Array, ...]:
        """Pictures of loaded objects at several moments, uint8, each of shape (h, w, 3).

        Much sooner than one by one. The bytes of each depend on its place in the series, too.

        Args:
            moments: What stands where in each.
            camera: From where.
            light: What falls on it.
            far: How far the camera sees, metres.

        Raises:
            RenderFailed: The worker died twice on this request.
            ValueError: An object isn't loaded.
        """
        drawn = self._ask_of(DrawSeries(tuple(map(tuple, moments)), camera, light, far))
        assert isinstance(drawn, Pictures)
        return drawn.rgb

    def _ask_of(self, request: DrawRequest | DrawColours | DrawSeries | Label | Outline) -> Answer:
        loaded = self._load.meshes if self._load else {}
        missing = sorted({each.object_id for each in request.objects} - loaded.keys())
        if missing:
            raise ValueError(f"load() before drawing: {', '.join(missing)}")
        return self._ask(request)

    def _ask(self, request: Request) -> Answer:
        reasons: list[str] = []
        for _ in range(2):
            try:
                return (self._worker or self._start()).ask(request)
            except (WorkerSilent, OSError) as error:
                reasons.append((self._worker and self._worker.last_words()) or str(error))
                self.close()
        raise RenderFailed(
            f"The render worker died twice on the same request: {reasons[-1]}. "
            "Check free memory and the Vulkan driver (vulkaninfo)."
        )

    def _start(self) -> _Worker:
        if self._load is None:
            raise ValueError("load() before drawing")
        worker = _Worker(self._engine, self._cache)
        self._worker = worker
        worker.ask(self._load)
        return worker


class _Worker:
    """One worker process and the socket to it."""

    def __init__(self, engine: RendererName, cache: Path | None) -> None:
        folder = [] if cache is None else [str(cache)]
        # The engines report their set-up on stdout and their faults on stderr.
        self._errors = tempfile.TemporaryFile("w+")  # noqa: SIM115 - closed in stop()
        self._process = start_module(
            "probe.render.worker", engine, *folder, stderr=self._errors.fileno()
        )
        self._timeout = TIMEOUTS[engine]

    @property
    def pid(self) -> int:
        return self._process.pid

    def ask(self, request: Request) -> Answer:
        self._process.send(request)
        if isinstance(request, DrawSeries):
            each = (cast(Pictures, self._receive()) for _ in request.moments)
            return Pictures(tuple(one for answer in each for one in answer.rgb))
        return self._receive()

    def _receive(self) -> Answer:
        return cast(Answer, self._process.receive(self._timeout))

    def last_words(self) -> str:
        self._process.kill()
        self._errors.seek(0)
        lines = [line.strip() for line in self._errors.read().splitlines() if line.strip()]
        faults = [line for line in lines if "reason:" in line or "ERROR" in line] or lines
        return faults[-1] if faults else ""

    def stop(self) -> None:
        self._process.end()
        self._errors.close()
