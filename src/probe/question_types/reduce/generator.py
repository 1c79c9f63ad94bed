"""Reduce: take these off; what was behind them? All of them are needed, none tells alone."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np

from probe.assets.library import Library
from probe.assets.spec import ObjectSpec
from probe.generation.covers import NEEDS_SLAB, Cover, draw_slab, draw_topping, footprint_of
from probe.generation.likeness import TWIN_TOLERANCE, Likeness, level_of, sides_of, whole_names_by
from probe.generation.object_selection import ObjectSelection, draw_cast, hideable, needs_alike
from probe.generation.removal import GhostRemoval, RemovalView
from probe.generation.result import Rejected, TaskCandidate
from probe.generation.setting_up import set_up
from probe.generation.stage import Layer, Poses
from probe.generation.task_generator import TaskGenerator
from probe.generation.task_plan import PlannedProperty, TaskPlan
from probe.generation.task_writer import Draft, write_task
from probe.generation.twins import (
    Lay,
    Twin,
    build_nest,
    check_hidden,
    draw_post,
    draw_twins,
    right_above,
)
from probe.generation.visibility_rules import (
    CLEAR_SHARE,
    HIDDEN_SHARE,
    LARGEST_GAIN,
    PARTLY,
    is_clear,
)
from probe.render.renderer import Renderer
from probe.scene.seeds import generator
from probe.tasks.english import listed
from probe.tasks.task import KIND_RULES
from probe.tasks.truth import which_on_table
from probe.types import Array

LARGEST, LARGEST_BENEATH_MORE = 0.09, 0.05
"""Longest sides in metres of what one thing hides, and several."""

MOST_REVEALED = PARTLY[1]
"""Visible share that the hidden thing may reach when only one of several is gone."""

REMOVALS = PlannedProperty("removals", (1, 1, 1, 2, 2, 2, 3, 3, 3, 4, 4, 5))
"""How many things are to be removed."""

_HIDING = 2
_SAILS = np.array([[1, 1], [-1, -1], [1, -1], [-1, 1]])
_BEYOND = 0.015
"""Metres by which a corner of the first slabs reaches past what they hide."""

_KEEP_OFF, _KEEP_OFF_MANY = 1.2, 1.7
_MANY = 3
_FEWEST, _MOST = 12, 15


def generate_reduce(
    seed: int, plan: TaskPlan, library: Library, renderer: Renderer, tables: Sequence[str]
) -> TaskCandidate:
    """One attempt.

    Raises:
        Rejected: It failed a check.
    """
    rng = generator(seed, "reduce")
    cast = select_reduce(library, plan, rng)
    many = REMOVALS.of(plan) >= _MANY
    post = draw_post(cast.covers, _KEEP_OFF_MANY if many else _KEEP_OFF, rng)
    ghosts = set_up(cast, [post], seed, plan, library, renderer, tables, rng)
    stage, view, frame = ghosts.stage, ghosts.view, ghosts.frame
    judge = _Judge(cast, ghosts)
    lay = _fanned(cast) if REMOVALS.of(plan) > 1 else right_above(cast.covering[0], cast.covers[0])
    hiding = min(_HIDING, REMOVALS.of(plan))

    def nest(target: int) -> Poses:
        return build_nest(stage, target, lay, post, rng, hiding)

    twins = draw_twins(cast, stage, nest, judge.check, frame, rng)
    true = cast.draw_true(rng)
    scene = twins[true].scene
    ids = [spec.id for spec in cast.candidates]
    target = which_on_table(scene, ids)
    order = [int(index) for index in rng.permutation(len(cast.covers))]
    names = [cast.covers[index].spec.name for index in order]
    draft = Draft(
        question_type="reduce",
        scene=scene,
        subject=", ".join(names),
        slots={"names": listed(names)},
        candidates=tuple(spec.name for spec in cast.candidates),
        truth=ids.index(target.object_id),
        targets=(target.instance,),
        cover=None,
        named=tuple(frame.number_of[cast.covering[index]] for index in order),
        measures=judge.measures[true],
        drawn_from=tuple(ids),
    )
    return TaskCandidate(write_task(draft, plan, view), tuple(twin.scene for twin in twins))


def select_reduce(library: Library, plan: TaskPlan, rng: np.random.Generator) -> ObjectSelection:
    """One slab that hides any of the candidates, or several, with the last of many on top.

    Raises:
        Rejected: The library has no such set.
    """
    # Many slabs need the room that a larger crowd would take.
    many = REMOVALS.of(plan) >= _MANY
    count = int(rng.integers(_FEWEST, (_FEWEST if many else _MOST) + 1))
    more = ([draw_slab] * (len(_SAILS) - 1) + [draw_topping])[: REMOVALS.of(plan) - 1]
    pool = hideable(library, LARGEST_BENEATH_MORE if more else LARGEST)
    if plan.rules >= KIND_RULES:
        pool = _hidden_by_one(library, pool, rng)
    likeness = Likeness(
        TWIN_TOLERANCE,
        sides=sides_of(plan.rules),
        level=level_of(plan.rules),
        whole_names=whole_names_by(plan.rules),
    )
    return draw_cast(library, pool, draw_slab, likeness, rng, count, more)


def _hidden_by_one(
    library: Library, pool: Sequence[ObjectSpec], rng: np.random.Generator
) -> list[ObjectSpec]:
    """What a slab hides that is drawn of all: else the few widest ones would be in most tasks.

    Raises:
        Rejected: The library has none.
    """
    slab = draw_slab(library, library.specs, (), rng)
    if slab is None:
        raise Rejected("cover", f"nothing here is {NEEDS_SLAB}")
    return [spec for spec in pool if slab.hides(footprint_of(library, spec.id))]


def _fanned(cast: ObjectSelection) -> Lay:
    """Lays slabs around a place like the sails of a windmill, and a topping on the last slab.

    The first two lie with a corner over the place, so that either hides what is there without the
    other; the next two lean against its sides, crosswise, and leave most of the first in view.
    """

    def lay(hidden: ObjectSpec, rng: np.random.Generator) -> list[Layer]:
        turn = float(rng.uniform(0, 2 * math.pi))
        cos, sin = math.cos(turn), math.sin(turn)
        radius = max(hidden.size[:2]) / 2
        off: Array = np.zeros(2)
        layers: list[Layer] = []
        for place, (number, cover) in enumerate(zip(cast.covering, cast.covers, strict=True)):
            spin = 0.0
            if place < len(_SAILS):
                crosswise = place >= _HIDING
                spin = _quarter(cover, crosswise=crosswise)
                half = np.sort(cover.extent[:2])[:: 1 if crosswise else -1] / 2
                reach = half + radius if crosswise else half - radius - _BEYOND
                off = np.maximum(reach, 0.0) * _SAILS[place]
            layers.append(
                Layer(number, cover, np.array([[cos, -sin], [sin, cos]]) @ off, turn + spin)
            )
        return layers

    return lay


def _quarter(cover: Cover, *, crosswise: bool) -> float:
    """The turn that lays a cover's long side along x, or crosswise along y."""
    x, y, _ = cover.extent
    return math.pi / 2 if (x < y) != crosswise else 0.0


@dataclass(frozen=True, eq=False)
class _Judge:
    """Checks the rules of Reduce on one twin after the other and keeps what it measured."""

    cast: ObjectSelection
    ghosts: GhostRemoval
    measures: dict[int, dict[str, float]] = field(default_factory=dict[int, dict[str, float]])

    def check(self, twin: Twin) -> None:
        """All rules on one scene; cheap ones first.

        Raises:
            Rejected: It breaks one.
        """
        look = self.ghosts.look(twin)
        numbers = look.number_of
        target, named = numbers[1], [numbers[instance] for instance in self.cast.covering]
        seen = look.before([target, *named])
        check_hidden(seen[target])
        if not all(is_clear(seen[number]) for number in named):
            least = min(seen[number].fraction for number in named)
            raise Rejected("named unclear", f"only {least:.0%} of one to be removed show")
        measured = {"hidden_share": seen[target].fraction, "removals": float(len(named))}
        if len(named) > 1:
            measured["revealed_by_one"] = self._revealed_by_one(look, target)
        others = {placed.instance for placed in twin.scene.objects} - {target, *named}
        hidden = [n for n, v in look.before(others).items() if v.fraction <= HIDDEN_SHARE]
        for how, after in look.removals(self.cast.covering):
            measured[f"revealed_{how}"] = share = look.share(after, target)
            if share < CLEAR_SHARE:
                raise Rejected(f"revealed {how}", f"only {share:.0%} show")
            risen = max((look.share(after, n) for n in hidden), default=0.0)
            if risen > LARGEST_GAIN:
                raise Rejected(f"others {how}", f"another hidden thing shows by {risen:.0%}")
        self.measures[twin.candidate] = measured

    def _revealed_by_one(self, look: RemovalView, target: int) -> float:
        """The most that shows of the target when a single thing is gone.

        Raises:
            Rejected: It is so much that the others needn't be removed.
        """
        most = 0.0
        for instance in self.cast.covering:
            for how, after in look.removals([instance]):
                most = max(most, look.share(after, target))
                if most > MOST_REVEALED:
                    raise Rejected(f"one tells {how}", f"{most:.0%} show without one of them")
        return most


GENERATOR = TaskGenerator(
    generate=generate_reduce,
    select=select_reduce,
    needs=f"{needs_alike(LARGEST, TWIN_TOLERANCE)} "
    f"(beneath several, up to {100 * LARGEST_BENEATH_MORE:g} cm); "
    f"over any of them one to five flat things {NEEDS_SLAB}",
    turns=(REMOVALS,),
)
