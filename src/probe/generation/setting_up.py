"""Sets up what a task's scenes are made with: physics, a view, and the numbers that things bear."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from probe.assets.library import Library
from probe.generation.frame import SceneFrame, frame_of
from probe.generation.object_selection import ObjectSelection
from probe.generation.removal import GhostRemoval
from probe.generation.scene_view import SceneView
from probe.generation.stage import Stage
from probe.generation.task_plan import TaskPlan
from probe.render.renderer import Renderer
from probe.world.model import Post


def set_up(
    cast: ObjectSelection,
    posts: Sequence[Post],
    seed: int,
    plan: TaskPlan,
    library: Library,
    renderer: Renderer,
    tables: Sequence[str],
    rng: np.random.Generator,
    *,
    apart: bool = False,
) -> GhostRemoval:
    """A stage for a cast, seen from above, and a frame on one of the tables.

    Args:
        cast: Who plays.
        posts: Discs that the crowd is kept off.
        seed: The scenes'.
        plan: Has the set-up.
        library: Has the objects.
        renderer: Looks; what was loaded in it is replaced.
        tables: Ids of table materials to choose from.
        rng: Draws the table, then the numbers.
        apart: Whether several candidates lie on the table, so that each has a number of its own.
    """
    stage = Stage(cast.specs, library, posts, plan.setup)
    view = SceneView(renderer, library, [spec.id for spec in cast.specs], plan.setup)
    table = tables[int(rng.integers(len(tables)))]
    if apart:
        frame = SceneFrame.of(cast.specs, seed, table, rng, plan.setup)
    else:
        frame = frame_of(cast, seed, table, rng, plan.setup)
    return GhostRemoval(stage, view, frame)
