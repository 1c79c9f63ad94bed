"""Memory: three unlike covers, over three of the candidates. Which of them did one cover hide?"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import partial

from probe.assets.library import Library
from probe.generation.bystanders import draw_bystanders
from probe.generation.edgewise_nests import EdgewiseNests
from probe.generation.necessary import with_necessary
from probe.generation.nests_judge import NestsJudge
from probe.generation.object_selection import ObjectSelection
from probe.generation.result import TaskCandidate
from probe.generation.scene_view import SceneView
from probe.generation.setting_up import set_up
from probe.generation.side_by_side import COVERS, draw_posts
from probe.generation.task_generator import TaskGenerator
from probe.generation.task_plan import TaskPlan
from probe.generation.task_writer import Draft, write_task
from probe.generation.twins import draw_twins
from probe.question_types.memory.casting import NEEDS, select_memory
from probe.question_types.memory.rules import RULES
from probe.render.renderer import Renderer
from probe.scene.scene import Scene
from probe.scene.seeds import generator
from probe.tasks.english import listed
from probe.tasks.truth import which_beneath

_KEEP_OFF = 1.25
"""The hand comes down beside a cover, and nothing there may be moved."""


def generate_memory(
    seed: int, plan: TaskPlan, library: Library, renderer: Renderer, tables: Sequence[str]
) -> TaskCandidate:
    """One attempt.

    Raises:
        Rejected: It failed a check.
    """
    rng = generator(seed, "memory")
    cast = select_memory(library, plan, rng)
    posts = draw_posts(cast.covers, _KEEP_OFF, rng)
    # Three candidates lie on the table, so that each needs a number of its own.
    ghosts = set_up(cast, posts, seed, plan, library, renderer, tables, rng, apart=True)
    stage, view, frame = ghosts.stage, ghosts.view, ghosts.frame
    places: list[int] = rng.permutation(COVERS).tolist()
    companions = [
        tuple(other + 1 for other in others) for others in draw_bystanders(RULES.bystanders, rng)
    ]
    nests = EdgewiseNests(cast, stage, posts, places, companions)
    judge = NestsJudge(nests, ghosts)

    twins = draw_twins(cast, stage, partial(nests.nest, rng=rng), judge.check, frame, rng)
    true = cast.draw_true(rng)
    asked = cast.covers[places[0]].spec.name
    order: list[int] = rng.permutation(COVERS).tolist()
    covers = {cast.covers[it].spec.name: frame.number_of[cast.covering[it]] for it in order}
    draft = _draft(cast, twins[true].scene, view, covers, asked, judge.measures[true])
    task = with_necessary(write_task(draft, plan, view), view, library)
    return TaskCandidate(task, tuple(twin.scene for twin in twins))


def _draft(
    cast: ObjectSelection,
    scene: Scene,
    view: SceneView,
    covers: Mapping[str, int],
    asked: str,
    measures: dict[str, float],
) -> Draft:
    """The task of a scene, without words and letters.

    Args:
        cast: Who plays.
        scene: The table.
        view: Sees it.
        covers: Their instances by name, in the order in which the question lists them.
        asked: Name of the one that it asks about.
        measures: What was measured.
    """
    shapes = view.silhouettes(scene, [placed.instance for placed in scene.objects])
    ids = [spec.id for spec in cast.candidates]
    target = which_beneath(scene, ids, covers[asked], shapes)
    return Draft(
        question_type="memory",
        scene=scene,
        subject=", ".join([asked, *(name for name in covers if name != asked)]),
        slots={"names": listed(list(covers)), "cover": asked},
        candidates=tuple(spec.name for spec in cast.candidates),
        truth=ids.index(target.object_id),
        targets=(target.instance,),
        cover=covers[asked],
        named=tuple(covers.values()),
        measures=measures,
        drawn_from=tuple(ids),
    )


GENERATOR = TaskGenerator(generate=generate_memory, select=select_memory, needs=NEEDS)
