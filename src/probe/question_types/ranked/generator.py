"""Ranked: three like covers, and something under each. Which of the three is how long?"""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

from probe.assets.library import Library
from probe.generation.covers import NEEDS_COVER
from probe.generation.edgewise_nests import EdgewiseNests
from probe.generation.likeness import longest
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
from probe.generation.toppings import TOPPED
from probe.generation.twins import draw_twins
from probe.question_types.ranked.casting import draw_companions, select_ranked
from probe.question_types.ranked.judge import RankedJudge
from probe.question_types.ranked.ladder import NEEDS_LADDER
from probe.question_types.ranked.rules import RANKS
from probe.question_types.ranked.truth import longest_first
from probe.render.renderer import Renderer
from probe.scene.scene import Scene
from probe.scene.seeds import generator
from probe.tasks.english import plural
from probe.tasks.type_rules import Form

_KEEP_OFF = 1.1


def generate_ranked(
    seed: int, plan: TaskPlan, library: Library, renderer: Renderer, tables: Sequence[str]
) -> TaskCandidate:
    """One attempt.

    Raises:
        Rejected: It failed a check.
    """
    rng = generator(seed, "ranked")
    cast = select_ranked(library, plan, rng)
    posts = draw_posts(cast.covers, _KEEP_OFF, rng)
    # Candidates lie beside each other here, so that each needs a number of its own.
    ghosts = set_up(cast, posts, seed, plan, library, renderer, tables, rng, apart=True)
    stage, view, frame = ghosts.stage, ghosts.view, ghosts.frame
    places: list[int] = rng.permutation(COVERS).tolist()
    nests = EdgewiseNests(cast, stage, posts, places, draw_companions(cast, plan.form, rng))
    base = NestsJudge(nests, ghosts)
    lengths = {number: longest(spec) for number, spec in enumerate(cast.specs, start=1)}

    twins = draw_twins(
        cast, stage, partial(nests.nest, rng=rng), RankedJudge(base, lengths).check, frame, rng
    )
    true = cast.draw_true(rng)
    covers = [frame.number_of[number] for number in cast.covering]
    draft = _draft(cast, plan.form, twins[true].scene, covers, view, base.measures[true])
    task = with_necessary(write_task(draft, plan, view), view, library)
    return TaskCandidate(task, tuple(twin.scene for twin in twins))


def _draft(
    cast: ObjectSelection,
    form: Form,
    scene: Scene,
    covers: Sequence[int],
    view: SceneView,
    measures: dict[str, float],
) -> Draft:
    """The task of a scene, without words and letters."""
    shapes = view.silhouettes(scene, [placed.instance for placed in scene.objects])
    lengths = {spec.id: longest(spec) for spec in cast.specs}
    found = longest_first(scene, covers, shapes, lengths)
    target, cover = found[RANKS.index(form)]
    others = [placed.instance for placed, _ in found if placed != target]
    ids, name = [spec.id for spec in cast.candidates], cast.covers[0].spec.name
    return Draft(
        question_type="ranked",
        scene=scene,
        subject=name,
        slots={"covers": str(plural(name))},
        candidates=tuple(spec.name for spec in cast.candidates),
        truth=ids.index(target.object_id),
        targets=(target.instance, *sorted(others)),
        cover=cover,
        measures=measures,
        drawn_from=tuple(ids),
    )


GENERATOR = TaskGenerator(
    generate=generate_ranked,
    select=select_ranked,
    needs=(
        f"{NEEDS_LADDER}; over any of them {NEEDS_COVER}, which can be lifted, be counted and is "
        "hollow enough to stand on the table"
    ),
    turns=(TOPPED,),
)
