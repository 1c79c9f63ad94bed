"""Find's tasks that need no manipulation: an option lies open, the cover hides something else."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from probe.assets.library import Library
from probe.generation.alike import unlike
from probe.generation.covers import footprint_of
from probe.generation.frame import SceneFrame
from probe.generation.in_view import check_open, is_open
from probe.generation.object_selection import ObjectSelection, hideable
from probe.generation.result import Rejected
from probe.generation.scene_view import SceneView
from probe.generation.stage import Stage
from probe.generation.task_plan import TaskPlan
from probe.generation.twins import build_nest, check_hidden, right_above
from probe.scene.scene import Scene
from probe.tasks.task import LETTERS
from probe.world.model import Post


def is_find_open(plan: TaskPlan) -> bool:
    """Whether the target lies open. No option does where none of them is right."""
    return is_open(plan) and plan.letter != LETTERS[-1]


def with_secret(
    library: Library, cast: ObjectSelection, largest: float, rng: np.random.Generator
) -> ObjectSelection:
    """The cast with something that is no option beneath the cover, and one of the crowd less.

    Args:
        library: To choose from.
        cast: Of a task whose target is hidden.
        largest: Longest side of what is hidden, metres.
        rng: Draws both.

    Raises:
        Rejected: Nothing else goes beneath it.
    """
    (cover,), taken = cast.covers, [*cast.candidates, cast.covers[0].spec, *cast.others]
    fitting = [
        spec
        for spec in unlike(hideable(library, largest), taken)
        if cover.hides(footprint_of(library, spec.id))
    ]
    if not fitting:
        raise Rejected("cover", f"{cover.spec.name} covers nothing but the candidates")
    secret = fitting[int(rng.integers(len(fitting)))]
    gone = int(rng.integers(len(cast.others)))
    others = (*cast.others[:gone], *cast.others[gone + 1 :])
    return replace(cast, beneath=(secret,), others=others)


def open_scene(
    cast: ObjectSelection,
    stage: Stage,
    post: Post,
    view: SceneView,
    frame: SceneFrame,
    rng: np.random.Generator,
) -> Scene:
    """A scene in which one candidate lies among the crowd, in plain view.

    Raises:
        Rejected: It doesn't, or things don't come to rest.
    """
    (secret,), target = cast.secrets, 1 + cast.draw_true(rng)
    lay = right_above(cast.covering[0], cast.covers[0])
    nest = build_nest(stage, secret, lay, post, rng)
    scene = frame.scene(stage.settle(stage.heap(nest, [*cast.crowd, target], rng)))
    below = frame.number_of[secret]
    check_hidden(view.visibility(scene, view.labels(scene), [below])[below])
    check_open(scene, view, [frame.number_of[target]])
    return scene
