"""Robot, table and objects in a recording: how they look, and where physics had them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from probe.assets.library import Library
from probe.assets.mesh.mesh import TexturedMesh
from probe.film.footage import Footage
from probe.film.recording.stream import RecordingWriter
from probe.film.watched_world import TableMoment
from probe.scene.scene import Scene
from probe.scene.setup import Setup
from probe.stage.furniture import furniture
from probe.stage.part import StagePiece
from probe.stage.stage import robot_frames, robot_pieces
from probe.types import Pose


def object_entity(instance: int, library: Library, object_id: str) -> str:
    """What an object is called in a recording."""
    return f"world/objects/{instance} {library[object_id].name}".replace(" ", "_")


def tell_looks(writer: RecordingWriter, scene: Scene, library: Library) -> None:
    """All that has a shape."""
    looks = scene.setup.looks
    for placed in scene.objects:
        mesh = library.body(placed.object_id, looks).mesh
        writer.body(object_entity(placed.instance, library, placed.object_id), mesh)
    _tell_pieces(writer, "world/robot", robot_pieces(scene.setup))
    colour = library.table(scene.table, looks).texture.reshape(-1, 3).mean(axis=0) / 255
    _tell_pieces(writer, "world/furniture", furniture(scene.setup, colour))


def tell_motion(writer: RecordingWriter, footage: Footage, library: Library) -> None:
    """Where all of it was: in time, and on the other timeline when each call was made."""
    setup = footage.task.setup
    moments = footage.moments
    places = [_places(moment, setup, library) for moment in moments]
    firsts = [call.first for call in footage.calls] + [len(moments) - 1]
    for entity in places[0]:
        poses = [each[entity] for each in places]
        # Between two rows the viewer keeps to the first of them.
        rows = [n for n, pose in enumerate(poses) if n == 0 or pose != poses[n - 1]]
        writer.motion(entity, [moments[n].time for n in rows], [poses[n] for n in rows])
        steps = range(1, len(firsts) + 1)
        writer.places(entity, steps, [poses[n] for n in firsts])


def _places(moment: TableMoment, setup: Setup, library: Library) -> Mapping[str, Pose]:
    frames = robot_frames(setup, moment.joints, moment.opening)
    parts = {f"world/robot/{name}": pose for name, pose in frames.items()}
    objects = {
        object_entity(placed.instance, library, placed.object_id): placed.pose
        for placed in moment.objects
    }
    return parts | objects


def _tell_pieces(writer: RecordingWriter, above: str, pieces: Sequence[StagePiece]) -> None:
    """Pieces of one colour each; those that move together as one mesh."""
    for frame in dict.fromkeys(piece.frame for piece in pieces):
        meshes = [piece.mesh for piece in pieces if piece.frame == frame]
        counts = [len(mesh.vertices) for mesh in meshes]
        starts = np.cumsum([0, *counts])[:-1]
        whole = TexturedMesh(
            vertices=np.vstack([mesh.vertices for mesh in meshes]),
            normals=np.vstack([mesh.normals for mesh in meshes]),
            uvs=np.vstack([mesh.uvs for mesh in meshes]),
            faces=np.vstack([m.faces + start for m, start in zip(meshes, starts, strict=True)]),
            surface=meshes[0].surface,
        )
        colours = [mesh.surface.texture[0, 0] for mesh in meshes]
        writer.body(f"{above}/{frame}", whole, np.repeat(colours, counts, axis=0))
