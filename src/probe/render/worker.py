"""The render worker: answers requests in a process of its own, and draws in forked children.

A driver's fault aborts a process, and Filament leaks some 30 MB with every RGB frame; a child that
draws one picture and exits costs 0.2 s more and can do neither harm. The worker itself never
touches the driver: that is what makes forking safe.
"""

from __future__ import annotations

import multiprocessing
import sys
from collections.abc import Callable
from dataclasses import replace
from multiprocessing.connection import Connection
from pathlib import Path

import numpy as np

from probe.assets.cache import Cache
from probe.assets.mesh import Surface
from probe.render.filament import Drawer
from probe.render.illumination import AMBIENT, Illumination
from probe.render.light_packing import LightPacker
from probe.render.packing import PackedMesh, pack, pack_table
from probe.render.protocol import Answer, Draw, Drawn, Load, Outline, Outlines, Request
from probe.types import Array

_FORK = multiprocessing.get_context("fork")
_PLAIN = Surface(np.full((1, 1, 3), 255, dtype=np.uint8))


class _Child:
    """A forked process that answers requests over a pipe."""

    def __init__(self, parent: Connection, serve: Callable[[Connection], None]) -> None:
        self.pipe, theirs = _FORK.Pipe()

        def run() -> None:
            parent.close()
            self.pipe.close()
            serve(theirs)

        self._process = _FORK.Process(target=run, daemon=True)
        self._process.start()
        theirs.close()

    def stop(self) -> None:
        self.pipe.close()
        self._process.join()


class _Loaded:
    """The objects at hand, and the child that draws labels and depth of them."""

    def __init__(self, load: Load, client: Connection, lights: LightPacker) -> None:
        self._client = client
        self._lights = lights
        self._meshes = {name: pack(mesh) for name, mesh in load.meshes.items()}
        self._table = pack_table(load.table)
        self._labeller: _Child | None = None

    def draw(self, request: Draw) -> Drawn:
        painter = None if request.light is None else self._painter(request, request.light)
        depth, labels = self._ask_labeller(replace(request, light=None))
        rgb: Array | None = None
        if painter:
            rgb = painter.pipe.recv()
            painter.stop()
        return Drawn(depth=depth, labels=labels, rgb=rgb)

    def outlines(self, request: Outline) -> Outlines:
        return Outlines(self._ask_labeller(request))

    def stop(self) -> None:
        if self._labeller:
            self._labeller.stop()

    def _ask_labeller(self, request: Draw | Outline):  # noqa: ANN202 - what the pipe carries
        self._labeller = self._labeller or _Child(self._client, self._serve_labels)
        self._labeller.pipe.send(request)
        return self._labeller.pipe.recv()

    def _painter(self, request: Draw, light: Illumination) -> _Child:
        packed = self._lights.pack(light)

        def paint(pipe: Connection) -> None:
            drawer = Drawer(self._meshes, self._table, packed)
            pipe.send(drawer.rgb(request.objects, request.camera))

        return _Child(self._client, paint)

    def _serve_labels(self, pipe: Connection) -> None:
        meshes = {name: _untextured(mesh) for name, mesh in self._meshes.items()}
        drawer = Drawer(meshes, _untextured(self._table), LightPacker().pack(AMBIENT))
        while True:
            try:
                request: Draw | Outline = pipe.recv()
            except EOFError:
                return
            pipe.send(_label(drawer, request))


def _label(drawer: Drawer, request: Draw | Outline) -> tuple[Array, Array] | dict[int, Array]:
    objects, camera = request.objects, request.camera
    if isinstance(request, Outline):
        return {item.instance: drawer.silhouette(item, camera) for item in objects}
    return drawer.depth(objects, camera), drawer.labels(objects, camera)


def _untextured(mesh: PackedMesh) -> PackedMesh:
    return PackedMesh(
        mesh.vertices, mesh.indices, mesh.vertex_count, mesh.index_count, mesh.bounds, _PLAIN
    )


def serve(client: Connection, lights: LightPacker) -> None:
    """Answer requests until the client goes away."""
    loaded: _Loaded | None = None
    while True:
        try:
            request: Request = client.recv()
        except EOFError:
            return
        if isinstance(request, Load):
            if loaded:
                loaded.stop()
            loaded = _Loaded(request, client, lights)
            answer: Answer = None
        elif loaded is None:
            raise ValueError("Draw before Load")
        else:
            answer = loaded.draw(request) if isinstance(request, Draw) else loaded.outlines(request)
        client.send(answer)


if __name__ == "__main__":
    handle, *folder = sys.argv[1:]
    serve(Connection(int(handle)), LightPacker(Cache(Path(folder[0])) if folder else None))
