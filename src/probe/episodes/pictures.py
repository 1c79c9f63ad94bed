"""Draws a recorded episode on demand, from its scenes alone."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from probe.episodes.record import EpisodeRecord
from probe.render.lighting import light_of
from probe.render.photograph import photograph
from probe.render.renderer import Renderer
from probe.scene.scene import Scene
from probe.types import Frame


def frames(
    record: EpisodeRecord, renderer: Renderer, assets: Path | None = None
) -> Iterator[Frame]:
    """The table at the start and after each step, as the camera saw it, drawn anew if it changed.

    Args:
        record: The episode.
        renderer: Has the objects and the table of the record's start loaded.
        assets: Folder of extra assets, where the record's light may lie.
    """
    light = light_of(record.sight.lighting, assets)
    drawn: tuple[Scene, Frame] | None = None
    for scene in record.scenes:
        if drawn is None or drawn[0] != scene:
            drawn = (scene, photograph(renderer, scene, camera=record.sight.camera, light=light))
        yield drawn[1]
