"""Where the camera stands and how the table is lit in a task under given conditions."""

from __future__ import annotations

from pathlib import Path

from probe.assets.environments import environment_names
from probe.episodes.circumstances import Circumstances
from probe.episodes.conditions import Conditions
from probe.runs.plan import Job, RunOrder
from probe.scene.perturb import VIEW_RANGES, CameraName, any_lighting, moved_view
from probe.scene.seeds import generator
from probe.scene.setup import RendererName
from probe.scene.viewpoint import Viewpoint
from probe.tasks.task import Task
from probe.types import Camera


def viewpoint_of(task: Task, conditions: Conditions, assets: Path | None) -> Viewpoint:
    """Drawn from the task's seed: the same for all agents and runs, another one for each task."""
    lighting = task.viewpoint.lighting
    if conditions.lighting == "hdri":
        lighting = any_lighting(environment_names(assets), generator(task.seed, "lighting"))
    return Viewpoint(camera_of(task, conditions.camera), lighting, renderer_of(task, conditions))


def renderer_of(task: Task, conditions: Conditions) -> RendererName:
    """What draws a task's pictures under given conditions."""
    return task.setup.renderer if conditions.renderer == "own" else conditions.renderer


def circumstances_of(order: RunOrder, job: Job, assets: Path | None) -> Circumstances:
    """What an order's episode differs in from others of its task."""
    viewpoint = viewpoint_of(job.task, order.conditions, assets)
    return Circumstances(job.run, order.noise, order.conditions, viewpoint, order.perception)


def camera_of(task: Task, name: CameraName) -> Camera:
    """The task's fixed camera, or one that strayed by what the task's seed draws."""
    fixed = task.viewpoint.camera
    if name == "fixed":
        return fixed
    return moved_view(fixed, generator(task.seed, "camera"), VIEW_RANGES[name])
