"""The pictures of a replay, each a file named by what it shows: drawn once, never again."""

from __future__ import annotations

import hashlib
import io
import json
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np
from PIL import Image

from probe.assets.mesh.fingerprint import Fingerprint
from probe.episodes.conditions import RendererKind
from probe.episodes.record import EpisodeRecord, Step
from probe.errors import BadData
from probe.files import encode, write_bytes
from probe.perception.things import Thing, Words
from probe.reading import contents
from probe.report.scene_renderer import SceneRenderer
from probe.scene.document import SceneDocument
from probe.scene.scene import Scene
from probe.scene.viewpoint import Viewpoint
from probe.tasks.marks import drawn
from probe.tasks.task import Mark, Task
from probe.toolshed.pictures import outlined
from probe.types import Array, Frame

_EDITION = 4
"""To be raised when the same table is drawn differently."""

_QUALITY = 60
"""Of WebP: at 1024 pixels about as many bytes as JPEG of quality 85 takes at 512."""

_DRAWN = 2
"""Times the usual size of marks and outlines: pages show pictures at half their size."""

_UNNAMED = Words(None, "", (), "")


@dataclass(frozen=True)
class Still:
    """A picture of a table, as an agent was given it.

    Attributes:
        scene: The table.
        viewpoint: From where and in which light.
        marks: Drawn on it.
        outline: Pixel (u, v) of a thing that is outlined; None for no outline.
        photo: Of a real table, the picture that its camera took; None in simulation.
    """

    scene: Scene
    viewpoint: Viewpoint = field(default_factory=Viewpoint)
    marks: tuple[Mark, ...] = ()
    outline: tuple[int, int] | None = None
    photo: Path | None = None


def stills_of(
    task: Task, record: EpisodeRecord, folder: Path, renderer: RendererKind = "own"
) -> tuple[Still, ...]:
    """What to show of an episode: the start, with its marks, and the table after each step.

    Args:
        task: What it was about.
        record: What happened.
        folder: Of the run; a robot's pictures lie there.
        renderer: What draws them: "own" for what drew them for the agent, or another.
    """
    seen = record.viewpoint
    if renderer != "own":
        seen = replace(seen, renderer=renderer)
    shown = (
        Still(record.start.scene, seen, marks=task.marks),
        *(Still(step.after.scene, seen, outline=_found(step)) for step in record.steps),
    )
    if not record.frames:
        return shown
    photos = [folder / f"{name}.jpg" for name in record.frames]
    # Outlines need labels, which no camera has.
    return tuple(
        replace(still, outline=None, photo=photo)
        for still, photo in zip(shown, photos, strict=True)
    )


def _found(step: Step) -> tuple[int, int] | None:
    return step.point_px if (step.call.name, step.status) == ("find_object", "done") else None


def file_of(still: Still, objects: Mapping[str, Fingerprint]) -> str:
    """The name of its file, which depends on all that it shows and on nothing else.

    Args:
        still: The picture.
        objects: Fingerprints by object id: what the objects look like is part of the picture.
    """
    if still.photo is not None:
        marks = [(mark.letter, mark.point) for mark in still.marks]
        told = repr((_EDITION, marks)).encode() + _taken(still.photo)
        return hashlib.sha256(told).hexdigest()[:20] + ".webp"
    shown = {placed.object_id for placed in still.scene.objects}
    said: list[object] = [
        _EDITION,
        SceneDocument.of(still.scene).model_dump(),
        _words_of(still.viewpoint),
        [(mark.letter, mark.point) for mark in still.marks],
        still.outline,
        {id: objects[id] for id in sorted(shown)},
    ]
    if still.viewpoint.renderer != still.scene.setup.renderer:
        said.append(still.viewpoint.renderer)
    return hashlib.sha256(json.dumps(said).encode()).hexdigest()[:20] + ".webp"


def _taken(photo: Path) -> bytes:
    try:
        return contents(photo)
    except OSError as error:
        remedy = "Keep a robot's folder of frames beside its records"
        raise BadData(photo, error.strerror or str(error), remedy) from error


def _words_of(viewpoint: Viewpoint) -> str:
    """A viewpoint, its renderer apart, in the words that named the pictures of earlier reports."""
    return f"Sight(camera={viewpoint.camera!r}, lighting={viewpoint.lighting!r})"


def develop(
    still: Still, task: Task, path: Path, scene_renderer: SceneRenderer, kept: Iterable[Path]
) -> None:
    """Write a picture, or take over the file of another folder if one has it.

    Raises:
        OutputFailed: It can't be written; nothing half-written is left.
        BadData: A file of another folder can't be read.
    """
    for folder in kept:
        try:
            write_bytes(path, contents(folder / path.name))
            return
        except FileNotFoundError:
            continue
        except OSError as error:
            reason = error.strerror or str(error)
            raise BadData(folder / path.name, reason, "Delete it; it is drawn again") from error
    if still.photo is not None:
        photo = np.asarray(Image.open(io.BytesIO(_taken(still.photo))))
        shown = drawn(photo, still.marks, _DRAWN)
    else:
        shown = _pixels(still, scene_renderer.frame(task, still.scene, still.viewpoint))
    write_bytes(path, encode(Image.fromarray(shown), "WEBP", quality=_QUALITY))


def _pixels(still: Still, frame: Frame) -> Array:
    assert frame.rgb is not None and frame.labels is not None
    if still.outline is None:
        return drawn(frame.rgb, still.marks, _DRAWN)
    u, v = still.outline
    mask = (frame.labels == frame.labels[v, u]) & (frame.labels[v, u] > 0)
    return outlined(frame.rgb, Thing.of(mask, _UNNAMED), _DRAWN) if mask.any() else frame.rgb
