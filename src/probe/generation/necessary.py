"""The fewest things that have to go before an answer can be seen: found by search over removals.

What is counted are removals of single things, each of which takes a manipulation or more.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import combinations

import numpy as np

from probe.assets.library import Library
from probe.generation.restored_stage import RestoredStage
from probe.generation.result import Rejected
from probe.generation.scene_view import SceneView
from probe.generation.visibility_rules import is_clear, is_seen
from probe.render.renderer import Renderer
from probe.scene.scene import Scene
from probe.scene.visibility import Visibility
from probe.tasks.task import NONE_OF_THE_ABOVE, OPEN_RULES, Task
from probe.tasks.truth import beneath_each
from probe.tasks.type_rules import rules_of
from probe.types import Array

NECESSARY = "necessary"
"""Name of the number among a certificate's measures."""

MOST = 6
"""Removals that are tried at once, at most."""


def view_of(task: Task, library: Library, renderer: Renderer) -> SceneView:
    """A task's table as its camera sees it; what was loaded in the renderer is replaced."""
    ids = [placed.object_id for placed in task.scene.objects]
    return SceneView(renderer, library, ids, task.setup, task.camera)


@dataclass(frozen=True, eq=False)
class RemovalSearch:
    """A table, and what looks at it and lets it come to rest again.

    Attributes:
        scene: The table at the start.
        view: Of the task's camera; has the scene's objects loaded.
        restaged: Its physics.
    """

    scene: Scene
    view: SceneView
    restaged: RestoredStage

    @staticmethod
    def of(task: Task, library: Library, renderer: Renderer) -> RemovalSearch:
        """Of a task's first picture; what was loaded in the renderer is replaced."""
        view = view_of(task, library, renderer)
        return RemovalSearch(task.scene, view, RestoredStage.of(task.scene, library))

    def necessary(self, task: Task) -> tuple[int, ...] | None:
        """The fewest instances without which a task's answer can be seen; None if more than MOST.

        They include what the task wants removed.
        """
        return self.fewest(self.evidence(task), task.named)

    def evidence(self, task: Task) -> tuple[int, ...]:
        """Instances that have to show before a task can be answered with certainty.

        They are its targets; that something is *not* there may take more, and so may a number.
        """
        wanted, rules = set(task.targets), rules_of(task.question_type)
        texts = {option.letter: option.text for option in task.options}
        none = texts[task.answer] == NONE_OF_THE_ABOVE
        if rules.numbered or (none and rules.searched == "table"):
            wanted |= {n for n, seen in self._shares(self.scene).items() if not is_seen(seen)}
        if none and rules.searched == "copies":
            wanted |= self._beneath_copies(task)
        return tuple(sorted(wanted))

    def _beneath_copies(self, task: Task) -> set[int]:
        """All that lies beneath anything that is the same as a task's cover."""
        assert task.cover is not None
        shapes = self.view.silhouettes(self.scene, [it.instance for it in self.scene.objects])
        return set[int]().union(*beneath_each(self.scene.like(task.cover), shapes).values())

    def fewest(
        self, evidence: Collection[int], required: Collection[int] = ()
    ) -> tuple[int, ...] | None:
        """The smallest set of instances without which half or more of each evidence shows.

        With everything else where it is, and after the rest has come to rest again.

        Args:
            evidence: Instances that must show; none of them is taken away.
            required: Instances that have to go in any case.
        """
        scene, view = self.scene, self.view
        shapes = view.silhouettes(scene, [placed.instance for placed in scene.objects])
        outlines = {number: shape.mask for number, shape in shapes.items()}
        hiding = [_PixelsHidden.of(scene, view, item, outlines) for item in evidence]
        useful = {number for each in hiding for number in each.by} - set(evidence) - set(required)
        for gone in _sets(sorted(useful), required):
            if all(each.clear_without(gone) for each in hiding) and self._holds(gone, evidence):
                return gone
        return None

    def _holds(self, gone: Sequence[int], evidence: Collection[int]) -> bool:
        """Whether the evidence still shows once the rest has come to rest again."""
        if not gone:
            return True
        bare = self.restaged
        settled = bare.moved(bare.stage.lift(bare.poses, *bare.places(*gone)))
        shown = self._shares(settled)
        return all(is_clear(shown[number]) for number in evidence)

    def _shares(self, scene: Scene) -> Mapping[int, Visibility]:
        numbers = [placed.instance for placed in scene.objects]
        return self.view.visibility(scene, self.view.labels(scene), numbers)


@dataclass(frozen=True, eq=False)
class _PixelsHidden:
    """Which things hide which pixels of one.

    Attributes:
        by: Instances that hide some of it; each has a bit, in this order.
        counts: Pixels of its outline by the set of things that hide them, by those bits.
    """

    by: tuple[int, ...]
    counts: Mapping[int, int]

    @staticmethod
    def of(
        scene: Scene, view: SceneView, item: int, outlines: Mapping[int, Array]
    ) -> _PixelsHidden:
        """Look at a thing with each of the others alone; outlines are bool, shape (h, w)."""
        mask = outlines[item]
        near = [n for n, other in outlines.items() if n != item and (other & mask).any()]
        over: dict[int, Array] = {}
        for number in near:
            labels = view.labels(scene.only(item, number))
            if (hidden := labels[mask] == number).any():
                over[number] = hidden
        patterns = np.zeros(np.count_nonzero(mask), dtype=np.int64)
        for bit, hidden in enumerate(over.values()):
            patterns |= hidden.astype(np.int64) << bit
        found, pixels = np.unique(patterns, return_counts=True)
        counts = dict(zip(found.tolist(), pixels.tolist(), strict=True))
        return _PixelsHidden(tuple(over), counts)

    def clear_without(self, gone: Collection[int]) -> bool:
        """Whether half or more of it shows without some things."""
        left = sum(1 << bit for bit, number in enumerate(self.by) if number not in gone)
        shown = sum(pixels for pattern, pixels in self.counts.items() if not pattern & left)
        return is_clear(Visibility(shown, sum(self.counts.values())))


def _sets(useful: Sequence[int], required: Collection[int]) -> Iterator[tuple[int, ...]]:
    """What is required with none, one and more of the others, the smallest sets first."""
    for count in range(max(0, MOST - len(required)) + 1):
        for some in combinations(useful, count):
            yield tuple(sorted({*required, *some}))


def is_answerable_at_sight(task: Task) -> bool:
    """Whether a task states that nothing has to go before its answer can be seen.

    By rules before OPEN_RULES there is no such task, whatever it states.
    """
    return task.version >= OPEN_RULES and task.certificate.measures.get(NECESSARY) == 0


def with_necessary(task: Task, view: SceneView, library: Library) -> Task:
    """A task whose certificate says how many things have to go before its answer can be seen.

    Raises:
        Rejected: Nothing that was tried shows it.
    """
    search = RemovalSearch(task.scene, view, RestoredStage.of(task.scene, library))
    found = search.necessary(task)
    if found is None:
        raise Rejected("necessary", f"no {MOST} removals or fewer show the answer")
    proof = task.certificate
    measures = {**proof.measures, NECESSARY: float(len(found))}
    return replace(task, certificate=replace(proof, measures=measures))


def necessary_removals(task: Task, library: Library, renderer: Renderer) -> tuple[int, ...] | None:
    """The fewest instances that have to go before a task's answer can be seen, of any type.

    Their number is the least number of manipulations, if each of them works at once. None if it is
    more than MOST. What was loaded in the renderer is replaced.
    """
    return RemovalSearch.of(task, library, renderer).necessary(task)
