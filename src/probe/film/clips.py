"""Short looping films of an episode's manipulations, for pages."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from probe.assets.library import Library
from probe.episodes.record import EpisodeRecord
from probe.film.cutting import moments_in_motion
from probe.film.drawing import StageDrawer, stage_drawer
from probe.film.encoding import encoded, require_encoder
from probe.film.filming import drawn_by
from probe.film.footage import FilmedCall, Footage, take
from probe.film.watched_world import SAMPLE_TIME
from probe.render.renderer import Renderer
from probe.scene.setup import RendererName
from probe.stage.cameras import whole_view
from probe.tasks.task import Task

FRAMES = 40
"""Of a clip."""

CLIP_FPS = 12
CLIP_PX = (560, 400)
"""Width and height."""


@dataclass(frozen=True)
class Clip:
    """A manipulation as a looping film without sound.

    Attributes:
        call: Number of the call in its record, from 0.
        content: A WebM file.
        speed: Of life's, on average, with idle time cut.
    """

    call: int
    content: bytes
    speed: float


def clips_of(
    task: Task,
    record: EpisodeRecord,
    library: Library,
    renderer: Renderer,
    *,
    stage: RendererName = "filament",
) -> tuple[Clip, ...]:
    """A clip of each call of an episode during which something moved.

    The episode is done again and compared with its record, as for a film.

    Args:
        task: What the record is about.
        record: The episode.
        library: Has the task's objects.
        renderer: Draws what the station sees, so it is the record's kind; what was loaded in it is
            replaced. The stage has one of its own.
        stage: What draws the stage; the files say so.

    Raises:
        CantFilm, OtherTools, MissingExtra: As film() does.
    """
    require_encoder()
    footage = take(task, record, library, renderer)
    moving = moments_in_motion(footage)
    with stage_drawer(task.scene, library, stage) as drawer:
        clips = [
            _clip(number, call, footage, moving, drawer)
            for number, call in enumerate(footage.calls)
        ]
    return tuple(clip for clip in clips if clip is not None)


def _clip(
    number: int, call: FilmedCall, footage: Footage, moving: Sequence[int], drawer: StageDrawer
) -> Clip | None:
    shown = [moment for moment in moving if call.first <= moment < call.last]
    if len(shown) < FRAMES:
        return None
    spaced: list[int] = np.linspace(0, len(shown) - 1, FRAMES).round().astype(int).tolist()
    moments = [footage.moments[shown[place]] for place in spaced]
    drawn = drawer.draw_all(moments, whole_view(footage.task.setup, *CLIP_PX))
    said = drawn_by(drawer.renderer.name)
    content = encoded(((picture, 1) for _, picture in drawn), CLIP_FPS, "webm", said)
    return Clip(number, content, len(shown) * SAMPLE_TIME * CLIP_FPS / FRAMES)
