"""One try at making a task: what it is made from, and what the task may show of that."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace

from probe.generation.build_folder import TaskSlot
from probe.generation.plan import ATTEMPTS, plan_of
from probe.generation.result import TaskCandidate
from probe.generation.salt import Salt
from probe.generation.task_plan import TaskPlan
from probe.generation.task_writer import task_id
from probe.scene.scene import Scene
from probe.scene.setup import UR5_TABLE, Setup
from probe.tasks.task import NEWEST_RULES, QuestionType, RulesVersion, Task

_ID_DIGITS = 16


@dataclass(frozen=True)
class Attempt:
    """One try at a place's task.

    Attributes:
        place: Which task.
        number: Of the try, from 0.
        salt: Of a private suite; None for a public one, where type and numbers decide all.
        setup: The table it is for.
        rules: The version of the rules that it is made by.
    """

    place: TaskSlot
    number: int
    salt: Salt | None = None
    setup: Setup = UR5_TABLE
    rules: RulesVersion = NEWEST_RULES

    @staticmethod
    def of_seed(question_type: QuestionType, seed: int, salt: Salt | None = None) -> Attempt:
        """The try at the public task that is made from a seed, or its like with a salt."""
        episode, number = divmod(seed, ATTEMPTS)
        return Attempt(TaskSlot(question_type, episode), number, salt)

    @staticmethod
    def of_task(task: Task) -> Attempt:
        """The try that made a public task, as its seed tells; see origins() for private ones."""
        return Attempt.of_seed(task.question_type, task.seed).by_the_rules_of(task)

    def by_the_rules_of(self, task: Task) -> Attempt:
        """The same try at the table and by the rules of a task."""
        return replace(self, setup=task.setup, rules=task.version)

    @property
    def plan(self) -> TaskPlan:
        """What the episode is to be like."""
        return plan_of(*self.place, self.salt, self.setup, self.rules)

    @property
    def seed(self) -> int:
        """What the scene is made from."""
        if self.salt is None:
            return self._public_seed
        return self.salt.number("scene", *self.place, self.number)

    @property
    def bears(self) -> int:
        """The seed that the task bears: the scene's, or one that only the salt leads from to it."""
        if self.salt is None:
            return self._public_seed
        return self.salt.seal(self._public_seed, self.place.question_type)

    @property
    def id(self) -> str:
        """The task's."""
        if self.salt is None:
            return task_id(self.place.question_type, self._public_seed)
        digits = self.salt.keyed("id", *self.place, self.number).hex()[:_ID_DIGITS]
        return f"{self.place.question_type}-{digits}"

    @property
    def _public_seed(self) -> int:
        return self.place.episode * ATTEMPTS + self.number

    def named(self, candidate: TaskCandidate) -> TaskCandidate:
        """What this try made, under the names that it may bear."""

        def renamed(scene: Scene) -> Scene:
            return replace(scene, seed=self.bears)

        task = candidate.task
        task = replace(task, id=self.id, seed=self.bears, scene=renamed(task.scene))
        return TaskCandidate(task, tuple(map(renamed, candidate.twins)))


def origins(tasks: Iterable[Task], salt: Salt) -> Mapping[str, Attempt]:
    """By which tries a private suite's tasks came about, by their ids; others are left out."""
    found = dict[str, Attempt]()
    for task in tasks:
        value = salt.unseal(task.seed, task.question_type)
        if value is not None:
            attempt = Attempt.of_seed(task.question_type, value, salt).by_the_rules_of(task)
            if attempt.id == task.id:
                found[task.id] = attempt
    return found
