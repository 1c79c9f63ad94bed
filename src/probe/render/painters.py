"""What draws colour pictures for a render worker: Filament in forked children, or Blender.

Depth and labels are always Filament's. A driver's fault aborts a process, and Filament leaks some
30 MB with every RGB frame; a child that draws one picture and exits costs 0.2 s more and can do
neither harm. The worker itself never touches the driver: that is what makes forking safe.
"""

from __future__ import annotations

from multiprocessing.connection import Connection
from typing import Protocol

from probe.render.filament import Drawer
from probe.render.light_packing import LightPacker
from probe.render.packing import PackedMesh
from probe.render.processes import Child, start_module
from probe.render.protocol import DrawRequest, Load
from probe.types import Array


class Packed(Protocol):
    """What a worker has loaded, as Filament's buffers."""

    meshes: dict[str, PackedMesh]
    table: PackedMesh


class Painter(Protocol):
    """Draws one picture at a time: begin(), do something else, finish()."""

    def load(self, load: Load, packed: Packed) -> None: ...

    def begin(self, request: DrawRequest) -> None: ...

    def finish(self) -> Array: ...


class FilamentPainter:
    """A forked child for each picture."""

    def __init__(self, client: Connection, lights: LightPacker) -> None:
        self._client = client
        self._lights = lights
        self._packed: Packed | None = None
        self._child: Child | None = None

    def load(self, load: Load, packed: Packed) -> None:
        self._packed = packed

    def begin(self, request: DrawRequest) -> None:
        packed = self._packed
        assert packed is not None and request.light is not None
        light = self._lights.pack(request.light)

        def paint(pipe: Connection) -> None:
            drawer = Drawer(packed.meshes, packed.table, light)
            pipe.send(drawer.rgb(request.objects, request.camera))

        self._child = Child(self._client, paint)

    def finish(self) -> Array:
        assert self._child is not None
        picture = self._child.pipe.recv()
        self._child.stop()
        return picture


class BlenderPainter:
    """One process of Blender's for all pictures: starting it takes seconds, and it forgets all."""

    def __init__(self) -> None:
        self._process, self._pipe = start_module("probe.render.blender")

    def load(self, load: Load, packed: Packed) -> None:
        self._send(load)

    def begin(self, request: DrawRequest) -> None:
        self._send(request)

    def finish(self) -> Array:
        try:
            return self._pipe.recv()
        except EOFError:
            raise SystemExit(1) from None

    def _send(self, request: Load | DrawRequest) -> None:
        """Hand on; if Blender has died, end as well: its last words are the ones to be read."""
        try:
            self._pipe.send(request)
        except OSError:
            raise SystemExit(1) from None
