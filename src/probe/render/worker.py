"""The render worker: answers requests in a process of its own.

`python -m probe.render.worker HANDLE ENGINE [CACHE]`; HANDLE is that of a connection.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator
from dataclasses import replace
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Any, cast

import numpy as np

from probe.assets.cache import Cache
from probe.assets.mesh.mesh import Material
from probe.processes.starting import fork
from probe.processes.worker_process import WorkerProcess
from probe.render.filament import Drawer
from probe.render.illumination import AMBIENT
from probe.render.light_packing import LightPacker
from probe.render.packing import PackedMesh, pack, table_quad
from probe.render.painters import BlenderPainter, FilamentPainter, Painter
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
)
from probe.types import Array

_PLAIN = Material(np.full((1, 1, 3), 255, dtype=np.uint8))


class _Loaded:
    """The objects at hand, and the child that draws labels and depth of them."""

    def __init__(self, load: Load, client: Connection) -> None:
        self._client = client
        self.meshes = {name: pack(mesh) for name, mesh in load.meshes.items()}
        self.table = pack(table_quad(load.table))
        self._labeller: WorkerProcess | None = None

    def draw(self, request: DrawRequest, painter: Painter) -> DrawReply:
        if request.light is not None:
            painter.begin(request)
        depth, labels = self._ask_labeller(replace(request, light=None))
        rgb = None if request.light is None else painter.finish()
        return DrawReply(depth=depth, labels=labels, rgb=rgb)

    def labels(self, request: Label) -> Labels:
        return Labels(self._ask_labeller(request))

    def outlines(self, request: Outline) -> Outlines:
        return Outlines(self._ask_labeller(request))

    def stop(self) -> None:
        if self._labeller:
            self._labeller.end(patience=None)

    def _ask_labeller(self, request: DrawRequest | Label | Outline):  # noqa: ANN202 - what the pipe carries
        self._labeller = self._labeller or fork(self._client, self._serve_labels)
        self._labeller.send(request)
        return cast(Any, self._labeller.receive())

    def _serve_labels(self, pipe: Connection) -> None:
        meshes = {name: _untextured(mesh) for name, mesh in self.meshes.items()}
        drawer = Drawer(meshes, _untextured(self.table), LightPacker().pack(AMBIENT))
        while True:
            try:
                request: DrawRequest | Label | Outline = pipe.recv()
            except EOFError:
                return
            pipe.send(_label(drawer, request))


def _label(
    drawer: Drawer, request: DrawRequest | Label | Outline
) -> tuple[Array, Array] | Array | dict[int, Array]:
    objects, camera = request.objects, request.camera
    if isinstance(request, Outline):
        return {item.instance: drawer.silhouette(item, camera) for item in objects}
    if isinstance(request, Label):
        return drawer.labels(objects, camera)
    return drawer.depth(objects, camera), drawer.labels(objects, camera)


def _untextured(mesh: PackedMesh) -> PackedMesh:
    return PackedMesh(
        mesh.vertices, mesh.indices, mesh.vertex_count, mesh.index_count, mesh.bounds, _PLAIN
    )


def serve(client: Connection, painter: Painter) -> None:
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
            loaded = _Loaded(request, client)
            painter.load(request, loaded)
            client.send(None)
        elif loaded is None:
            raise ValueError("Draw before Load")
        else:
            for answer in _answers(request, loaded, painter):
                client.send(answer)


def _answers(
    request: DrawRequest | DrawColours | DrawSeries | Label | Outline,
    loaded: _Loaded,
    painter: Painter,
) -> Iterator[Answer]:
    """One answer, or one for each picture of a series."""
    if isinstance(request, DrawSeries):
        for picture in painter.series(request):
            yield Pictures((picture,))
    elif isinstance(request, DrawRequest):
        yield loaded.draw(request, painter)
    elif isinstance(request, DrawColours):
        painter.begin(DrawRequest(request.objects, request.camera, request.light))
        yield Pictures((painter.finish(),))
    elif isinstance(request, Label):
        yield loaded.labels(request)
    else:
        yield loaded.outlines(request)


def _painter(client: Connection, engine: str, cache: str | None) -> Painter:
    if engine == "blender":
        return BlenderPainter()
    return FilamentPainter(client, LightPacker(Cache(Path(cache)) if cache else None))


if __name__ == "__main__":
    handle, engine, *folder = sys.argv[1:]
    connection = Connection(int(handle))
    chosen = _painter(connection, engine, folder[0] if folder else None)
    serve(connection, chosen)
    chosen.end()
