"""What a model without tools is shown of a task, in each setting. Knows no model."""

from __future__ import annotations

from probe.assets.library import Library
from probe.episodes.oracle_view import oracle_view
from probe.render.lighting import light_of
from probe.render.photograph import load_scene, photograph
from probe.render.renderer import Renderer
from probe.scene.viewpoint import Viewpoint
from probe.tasks.marks import drawn
from probe.tasks.task import Task
from probe.transcripts.prompts import Setting
from probe.types import Array


def stills(
    setting: Setting, task: Task, viewpoint: Viewpoint, things: Library, renderer: Renderer
) -> tuple[Array, ...]:
    """Pictures that come with the question; replaces what the renderer had loaded.

    Args:
        setting: Without tools: None in "blind", two in "oracle-view", else one.
        task: Whose table.
        viewpoint: From where and in which light it is seen.
        things: Has the task's objects.
        renderer: Draws.
    """
    if setting == "blind":
        return ()
    if setting == "oracle-view":
        frames = oracle_view(task, things, renderer, viewpoint).frames
        return tuple(frame.rgb for frame in frames if frame.rgb is not None)
    load_scene(renderer, task.scene, things)
    light = light_of(viewpoint.lighting, things.assets)
    frame = photograph(renderer, task.scene, camera=viewpoint.camera, light=light)
    assert frame.rgb is not None
    return (drawn(frame.rgb, task.marks),)
