"""What draws colour pictures for a render worker: Filament in forked children, or Blender.

Depth and labels are always Filament's. A driver's fault aborts a process, and Filament leaks some
30 MB with every RGB frame; a child that draws one picture and exits costs 0.2 s more and can do
neither harm. The worker itself never touches the driver: that is what makes forking safe.
"""

from __future__ import annotations

from collections.abc import Generator, Iterator
from contextlib import contextmanager
from multiprocessing.connection import Connection
from typing import Protocol, cast

from probe.processes.starting import fork, start_module
from probe.processes.worker_process import WorkerProcess, WorkerSilent
from probe.render.filament import Drawer
from probe.render.light_packing import LightPacker
from probe.render.packing import PackedMesh
from probe.render.protocol import DrawRequest, DrawSeries, Load
from probe.types import Array


class Packed(Protocol):
    """What a worker has loaded, as Filament's buffers."""

    meshes: dict[str, PackedMesh]
    table: PackedMesh


class Painter(Protocol):
    """Draws one picture at a time: begin(), do something else, finish(); or a whole series."""

    def load(self, load: Load, packed: Packed) -> None: ...

    def begin(self, request: DrawRequest) -> None: ...

    def finish(self) -> Array: ...

    def series(self, request: DrawSeries) -> Iterator[Array]: ...

    def end(self) -> None: ...


class FilamentPainter:
    """A forked child for each picture."""

    def __init__(self, client: Connection, lights: LightPacker) -> None:
        self._client = client
        self._lights = lights
        self._packed: Packed | None = None
        self._child: WorkerProcess | None = None

    def load(self, load: Load, packed: Packed) -> None:
        self._packed = packed

    def begin(self, request: DrawRequest) -> None:
        packed = self._packed
        assert packed is not None and request.light is not None
        light = self._lights.pack(request.light)

        def paint(pipe: Connection) -> None:
            drawer = Drawer(packed.meshes, packed.table, light)
            pipe.send(drawer.rgb(request.objects, request.camera))

        self._child = fork(self._client, paint)

    def finish(self) -> Array:
        assert self._child is not None
        picture = self._child.receive()
        self._child.end(patience=None)
        return cast(Array, picture)

    def series(self, request: DrawSeries) -> Iterator[Array]:
        """All pictures of one child, which costs a fifth of as many children."""
        packed, light = self._packed, self._lights.pack(request.light)
        assert packed is not None

        def paint(pipe: Connection) -> None:
            drawer = Drawer(packed.meshes, packed.table, light, quick=True)
            for moment in request.moments:
                pipe.send(drawer.rgb(moment, request.camera, request.far))

        child = fork(self._client, paint)
        for _ in request.moments:
            yield cast(Array, child.receive())
        child.end(patience=None)

    def end(self) -> None:
        """Every child has ended with its pictures."""


class BlenderPainter:
    """One process of Blender's for all pictures: starting it takes seconds, and it forgets all."""

    def __init__(self) -> None:
        self._process = start_module("probe.render.blender")

    def load(self, load: Load, packed: Packed) -> None:
        with _end_alike():
            self._process.send(load)

    def begin(self, request: DrawRequest) -> None:
        with _end_alike():
            self._process.send(request)

    def finish(self) -> Array:
        with _end_alike():
            return cast(Array, self._process.receive())

    def series(self, request: DrawSeries) -> Iterator[Array]:
        """All pictures of one scene, which is filled once."""
        with _end_alike():
            self._process.send(request)
        for _ in request.moments:
            yield self.finish()

    def end(self) -> None:
        """End Blender's process, which waits and keeps nothing, and learn the CPU time it took."""
        self._process.kill()


@contextmanager
def _end_alike() -> Generator[None]:
    """If Blender has died, end as well: its last words are the ones to be read."""
    try:
        yield
    except WorkerSilent:
        raise SystemExit(1) from None
