"""One try at making a task: what it is made from, and what the task may show of that."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass, replace
from itertools import product

from probe.certify.parts import Place
from probe.certify.plan import ATTEMPTS, Plan, plan_of
from probe.certify.result import Candidate
from probe.certify.salt import PRIVATE_FROM, Salt
from probe.certify.writing import task_id
from probe.scene.scene import Scene
from probe.tasks.task import KINDS, QuestionKind, Task

FARTHEST = 1000
"""Episodes of a type, beyond its number of tasks, among which origins() looks."""

_ID_DIGITS = 16


@dataclass(frozen=True)
class Attempt:
    """One try at a place's task.

    Attributes:
        place: Which task.
        number: Of the try, from 0.
        salt: Of a private suite; None for a public one, where type and numbers decide all.
    """

    place: Place
    number: int
    salt: Salt | None = None

    @staticmethod
    def of_seed(kind: QuestionKind, seed: int) -> Attempt:
        """The try at a public task that is made from a seed."""
        episode, number = divmod(seed, ATTEMPTS)
        return Attempt(Place(kind, episode), number)

    @property
    def plan(self) -> Plan:
        """What the episode is to be like."""
        return plan_of(*self.place, self.salt)

    @property
    def seed(self) -> int:
        """What the scene is made from."""
        if self.salt is None:
            return self.place.episode * ATTEMPTS + self.number
        return self.salt.number("scene", *self.place, self.number)

    @property
    def bears(self) -> int:
        """The seed that the task bears: the scene's, or one that only the salt leads from to it."""
        if self.salt is None:
            return self.seed
        return PRIVATE_FROM | self.salt.number("bears", *self.place, self.number)

    @property
    def id(self) -> str:
        """The task's."""
        if self.salt is None:
            return task_id(self.place.kind, self.seed)
        return _private_id(self.salt, *self.place, self.number)

    def named(self, candidate: Candidate) -> Candidate:
        """What this try made, under the names that it may bear."""

        def renamed(scene: Scene) -> Scene:
            return replace(scene, seed=self.bears)

        task = candidate.task
        task = replace(task, id=self.id, seed=self.bears, scene=renamed(task.scene))
        return Candidate(task, tuple(map(renamed, candidate.twins)))


def origins(tasks: Collection[Task], salt: Salt, farthest: int = FARTHEST) -> Mapping[str, Attempt]:
    """By which tries a private suite's tasks came about, by their ids; others are left out."""
    found = dict[str, Attempt]()
    for kind in KINDS:
        wanted = {task.id for task in tasks if task.kind == kind}
        # First tries first: most tasks need few.
        tries = product(range(ATTEMPTS), range(len(wanted) + farthest)) if wanted else ()
        for number, episode in tries:
            name = _private_id(salt, kind, episode, number)
            if name in wanted:
                found[name] = Attempt(Place(kind, episode), number, salt)
                wanted.discard(name)
            if not wanted:
                break
    return found


def _private_id(salt: Salt, kind: QuestionKind, episode: int, number: int) -> str:
    return f"{kind}-{salt.keyed('id', kind, episode, number).hex()[:_ID_DIGITS]}"
