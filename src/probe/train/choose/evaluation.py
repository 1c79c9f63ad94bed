"""What belongs to evaluation and mustn't be trained on: tasks, seeds, scenes, objects."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Literal

from probe.assets.pools.split import Split
from probe.generation.plan import ATTEMPTS
from probe.generation.salt import PRIVATE_FROM
from probe.scene.scene import Scene
from probe.tasks.suite import Suite
from probe.tasks.suite_file import digest_of
from probe.tasks.task import Task
from probe.tasks.type_rules import rules_of
from probe.train.collect.training import FIRST_EPISODE

Leak = Literal["task", "seed", "scene", "object", "unsplit object"]
"""Why a task is refused: it is of a suite; its seed is, or isn't for training; its scene is nearly
a suite's; it shows or names an object for evaluation; or one that the split doesn't know."""

SHARED = 0.5
"""Scenes are near-duplicates if more than this share of the smaller one's things is in both."""


@dataclass(frozen=True)
class TrainingRefusal:
    """A task that mustn't be trained on.

    Attributes:
        task: Its id.
        leak: Why, in one word.
        detail: What it collides with.
    """

    task: str
    leak: Leak
    detail: str


@dataclass(frozen=True)
class Evaluation:
    """All that training keeps away from.

    Attributes:
        digests: Suite and task by content.
        seeds: Suite by seed.
        scenes: Name of each suite's scene, and how often it shows which object.
        split: Which objects are for evaluation; None if nobody split them.
        groups: For each object with near-duplicates the name of its group.
    """

    digests: Mapping[str, str]
    seeds: Mapping[int, str]
    scenes: Sequence[tuple[str, Counter[str]]]
    split: Split | None = None
    groups: Mapping[str, str] = field(default_factory=dict[str, str])

    def refusal(self, task: Task) -> TrainingRefusal | None:
        """Why a task mustn't be trained on; None if it may."""
        for leak, detail in self._leaks(task):
            return TrainingRefusal(task.id, leak, detail)
        return None

    def _leaks(self, task: Task) -> Iterable[tuple[Leak, str]]:
        digest = digest_of(task)
        if digest in self.digests:
            yield "task", self.digests[digest]
        if task.seed in self.seeds:
            yield "seed", f"{task.seed} is of {self.seeds[task.seed]}"
        elif task.seed < FIRST_EPISODE * ATTEMPTS:
            yield "seed", f"{task.seed} is below {FIRST_EPISODE * ATTEMPTS}"
        elif task.seed >= PRIVATE_FROM:
            yield "seed", f"{task.seed} is of a private suite"
        if near := self._near(task.scene):
            yield "scene", near
        yield from self._objects(task)

    def _near(self, scene: Scene) -> str | None:
        """The suite's scene that this one is nearly the same as."""
        mine = cast_of(scene, self.groups)
        for name, theirs in self.scenes:
            smaller = min(mine.total(), theirs.total())
            if (mine & theirs).total() > SHARED * smaller:
                return name
        return None

    def _objects(self, task: Task) -> Iterable[tuple[Leak, str]]:
        """Of what is shown or offered, the first that isn't for training."""
        if self.split is None:
            return
        parts = self.split.parts
        numbered = rules_of(task.question_type).numbered
        offered = [] if numbered else list(task.certificate.candidates)
        evaluated = {self.groups.get(id, id) for id, part in parts.items() if part == "evaluation"}
        for id in [*(placed.object_id for placed in task.scene.objects), *offered]:
            if self.groups.get(id, id) in evaluated:
                yield "object", id
            elif id not in parts:
                yield "unsplit object", id


def evaluation_of(
    suites: Sequence[Suite],
    split: Split | None = None,
    groups: Iterable[Sequence[str]] = (),
) -> Evaluation:
    """All that training keeps away from.

    Args:
        suites: That models are evaluated on.
        split: Which objects are for evaluation.
        groups: Objects that are near-duplicates of each other.
    """
    named = {id: group[0] for group in groups for id in group if len(group) > 1}
    tasks = [(suite.name, task) for suite in suites for task in suite.tasks]
    return Evaluation(
        digests={digest_of(task): f"{name}, {task.id}" for name, task in tasks},
        seeds={task.seed: f"{name}, {task.id}" for name, task in tasks},
        scenes=[(f"{name}, {task.id}", cast_of(task.scene, named)) for name, task in tasks],
        split=split,
        groups=named,
    )


def cast_of(scene: Scene, groups: Mapping[str, str]) -> Counter[str]:
    """How often a scene shows which object; near-duplicates count as the same."""
    return Counter(groups.get(placed.object_id, placed.object_id) for placed in scene.objects)
