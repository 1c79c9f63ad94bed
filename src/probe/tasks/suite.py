"""A frozen set of tasks, and the fingerprints that say whether it is still what it was."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TypeVar

from probe.assets.library import Library, Pool
from probe.assets.looks import Looks
from probe.assets.mesh.fingerprint import Fingerprint, same
from probe.assets.pools.scans import FETCH_THEM, is_scan
from probe.errors import BadData, UnknownName
from probe.tasks.headline import HeadlineErrors
from probe.tasks.task import Task

_Item = TypeVar("_Item")


@dataclass(frozen=True)
class Suite:
    """Tasks that are always run together.

    Attributes:
        name: "v2", "demo".
        tasks: In a fixed order. `for task in suite` goes through them, `len(suite)` counts them,
            and `suite["find-c09c4db2"]` is one of them.
        objects: Fingerprint of each object that appears, by id.
        commitment: To the salt that a private suite was made with; None of a public one.
        pool: Which objects it was made of; None of suites from before this was written down.
        headline: The errors of tools that its scores are compared under; None of suites whose
            files say nothing of it, which are run without errors unless somebody asks for them.
    """

    name: str
    tasks: tuple[Task, ...]
    objects: Mapping[str, Fingerprint]
    commitment: str | None = None
    pool: Pool | None = None
    headline: HeadlineErrors | None = None

    def __iter__(self) -> Iterator[Task]:
        """Its tasks, in their order."""
        return iter(self.tasks)

    def __len__(self) -> int:
        """How many tasks there are."""
        return len(self.tasks)

    def __getitem__(self, task: str) -> Task:
        """A task by its id.

        Raises:
            UnknownName: There is none of this id.
        """
        found = {each.id: each for each in self.tasks}
        if task not in found:
            raise UnknownName("task", task, list(found))
        return found[task]


def freeze(
    name: str, tasks: tuple[Task, ...], library: Library, headline: HeadlineErrors | None = None
) -> Suite:
    """A suite of these tasks, with the fingerprints of their objects as they are now."""
    looks = _looks_of(tasks)
    marks = {id: library.fingerprint(id, looks[id]) for id in sorted(looks)}
    return Suite(name, tasks, marks, pool=library.pool, headline=headline)


def _looks_of(tasks: Sequence[Task]) -> dict[str, Looks]:
    """How each object looks, by id; where tasks differ in that, as in the first of them."""
    looks: dict[str, Looks] = {}
    for task in tasks:
        for placed in task.scene.objects:
            looks.setdefault(placed.object_id, task.setup.looks)
    return looks


def part(suite: Suite, task: Task) -> Suite:
    """One task of a suite alone, with the fingerprints of its objects."""
    return selection(suite, (task,), suite.name)


def selection(suite: Suite, tasks: tuple[Task, ...], name: str) -> Suite:
    """Some tasks of a suite under another name, with the fingerprints of their objects."""
    ids = sorted({placed.object_id for task in tasks for placed in task.scene.objects})
    return replace(suite, name=name, tasks=tasks, objects={id: suite.objects[id] for id in ids})


def spaced(tasks: Sequence[_Item], count: int) -> tuple[_Item, ...]:
    """So many tasks, or records in order of tasks, evenly spaced; all if there are fewer."""
    count = min(count, len(tasks))
    return tuple(tasks[number * len(tasks) // count] for number in range(count))


def check_objects(
    suite: Suite, library: Library, watch: Callable[[Iterable[str]], Iterable[str]] = iter
) -> None:
    """Refuse a library whose objects aren't those that the suite was made with.

    Args:
        suite: Its fingerprints are compared.
        library: Has its objects.
        watch: Goes through their ids and may show how far it is: new ones take a while.

    Raises:
        BadData: An object is missing or differs.
    """
    looks = _looks_of(suite.tasks)
    for object_id in watch(suite.objects):
        frozen = suite.objects[object_id]
        try:
            found = library.fingerprint(object_id, looks.get(object_id, 1))
        except UnknownName as error:
            raise _missing(suite, object_id) from error
        if not same(found, frozen):
            reason = f"{object_id} has changed since"
            raise BadData(f"suite {suite.name}", reason, _remedy(object_id))


def check_known(suite: Suite, library: Library) -> None:
    """Refuse a library that lacks an object of the suite; whether it has changed isn't seen.

    Raises:
        BadData: An object is missing.
    """
    here = {spec.id for spec in library.specs}
    for object_id in suite.objects:
        if object_id not in here:
            raise _missing(suite, object_id)


def _missing(suite: Suite, object_id: str) -> BadData:
    return BadData(f"suite {suite.name}", f"there is no {object_id} here", _remedy(object_id))


def _remedy(object_id: str) -> str:
    """Where the object that a suite was made with comes from."""
    if is_scan(object_id):
        return FETCH_THEM
    return "Use the assets and the release that the suite was made with, or build it again"
