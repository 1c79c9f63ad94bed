"""Draws a recorded episode on demand, from its scenes alone."""

from __future__ import annotations

from collections.abc import Iterator

from probe.episodes.record import EpisodeRecord
from probe.render.photograph import photograph
from probe.render.renderer import Renderer
from probe.scene.scene import Scene
from probe.types import Frame


def frames(record: EpisodeRecord, renderer: Renderer) -> Iterator[Frame]:
    """The table at the start and after each step, from above; drawn anew only if it changed.

    Args:
        record: The episode.
        renderer: Has the objects and the table of the record's start loaded.
    """
    drawn: tuple[Scene, Frame] | None = None
    for scene in record.scenes:
        if drawn is None or drawn[0] != scene:
            drawn = (scene, photograph(renderer, scene))
        yield drawn[1]
