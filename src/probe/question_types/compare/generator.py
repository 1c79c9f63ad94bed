"""Compare: which of two marked things has a colour? What shows of them can't tell.

By newer rules both lie open in a quarter of the tasks, and what shows does tell.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from probe.assets.library import Library
from probe.generation.covers import NEEDS_SHIELD
from probe.generation.in_view import OPEN_QUARTER, is_open
from probe.generation.marked import (
    MARKABLE,
    CoveredThing,
    MarkedSelection,
    MarkedStage,
    build_set,
    draw_marks,
    settle_around,
    settle_open,
)
from probe.generation.result import Rejected, TaskCandidate
from probe.generation.task_generator import TaskGenerator
from probe.generation.task_plan import CROSSED, MORE_CUES, TaskPlan
from probe.generation.task_writer import Draft, write_task
from probe.generation.twin_pairs import ColourQuestion
from probe.generation.twin_placement import check_unpainted
from probe.generation.twin_worlds import CompareQuestion, look_at_open_worlds, look_at_worlds
from probe.generation.visibility_rules import is_clear
from probe.question_types.compare.casting import (
    draw_covered,
    more_of_a,
    select_compare,
    twins_of,
)
from probe.render.renderer import Renderer
from probe.scene.scene import Scene
from probe.scene.seeds import generator
from probe.tasks.task import AIM_RULES, Mark

_CROWDS = 3
"""How often the others are thrown, at most."""


def generate_compare(
    seed: int, plan: TaskPlan, library: Library, renderer: Renderer, tables: Sequence[str]
) -> TaskCandidate:
    """One attempt.

    The opposite plan gives the same scene, but for paint: it fails where this one does. That paint
    doesn't show, so that nothing that can be seen goes with the answer; or, where the two lie open,
    it alone tells.

    Raises:
        Rejected: It failed a check.
    """
    rng = generator(seed, "compare")
    lie_open = is_open(plan, OPEN_QUARTER)

    def stage(cast: MarkedSelection) -> MarkedStage:
        hidden = not lie_open
        return build_set(cast, seed, library, renderer, tables, rng, plan.setup, keep_off=hidden)

    if lie_open:
        asked, cast = select_compare(library, plan, rng)
        made = stage(cast)
        scene = settle_open(made, rng)
        marks = _marks(made, asked, scene)
    else:
        asked, made, nests = draw_covered(library, plan, rng, stage)
        scene, marks = _among_others(made, asked, nests, plan, library, rng)
    labels, reference = made.view.labels(scene), _reference(made, asked)
    matter = CompareQuestion(plan.form, made.marked, twins_of(asked), asked.word, reference)
    if lie_open:
        measures = look_at_open_worlds(matter, scene, labels, asked.right, library, renderer)
    else:
        measures = look_at_worlds(matter, scene, labels, asked.right, library, renderer)
        if (measures["patch_lead"] > 0) != CROSSED.of(plan)[1]:
            raise Rejected("cues", "in the picture, the other patch fits better")
    # Pictures loaded textures; the certificate's visibilities need none, and both see the same.
    draft = _draft(asked, made, scene, marks, measures)
    return TaskCandidate(write_task(draft, plan, made.view))


def _draft(
    asked: ColourQuestion,
    made: MarkedStage,
    scene: Scene,
    marks: tuple[Mark, Mark],
    measures: Mapping[str, float],
) -> Draft:
    """The task of a scene, without words and letters."""
    name = asked.reference.name if asked.reference else ""
    return Draft(
        question_type="compare",
        scene=scene,
        subject=asked.word or name,
        slots={"colour": asked.word, "name": name},
        candidates=(),
        truth=asked.right,
        targets=made.marked,
        marks=marks,
        measures=measures,
        drawn_from=tuple(spec.id for spec in (*asked.marked, *asked.twins)),
    )


def _among_others(
    made: MarkedStage,
    asked: ColourQuestion,
    nests: tuple[CoveredThing, CoveredThing],
    plan: TaskPlan,
    library: Library,
    rng: np.random.Generator,
) -> tuple[Scene, tuple[Mark, Mark]]:
    """The scene with all others around both nests, and its marks.

    By newer rules the others are thrown anew where they cover too much.

    Raises:
        Rejected: They always do, or don't come to rest.
    """
    for left in reversed(range(_CROWDS if plan.rules >= AIM_RULES else 1)):
        try:
            scene = settle_around(made, nests, rng)
            marks = _marks(made, asked, scene)
            labels = made.view.labels(scene)
            check_unpainted(made, scene, labels, twins_of(asked), library, more_of_a(plan))
        except Rejected:
            if not left:
                raise
        else:
            return scene, marks
    raise AssertionError("the last one returns or raises")


def _marks(made: MarkedStage, asked: ColourQuestion, scene: Scene) -> tuple[Mark, Mark]:
    """The marks of a scene.

    Raises:
        Rejected: One has no room, or what colours are compared with isn't clear.
    """
    labels, reference = made.view.labels(scene), _reference(made, asked)
    if reference is not None:
        seen = made.view.visibility(scene, labels, [reference])[reference]
        if not is_clear(seen):
            raise Rejected(
                "reference", f"only {seen.fraction:.0%} of what it is compared with show"
            )
    return draw_marks(made, labels)


def _reference(made: MarkedStage, asked: ColourQuestion) -> int | None:
    """The scene's number of what colours are compared with, the last of the cast; or None."""
    return made.frame.number_of[len(made.cast.specs)] if asked.reference else None


GENERATOR = TaskGenerator(
    generate=generate_compare,
    select=select_compare,
    needs="two kinds of things, each in two paints of one shape, which scans never are "
    f"({MARKABLE}); over either, two {NEEDS_SHIELD}",
    turns=(MORE_CUES, OPEN_QUARTER),
)
