"""What a task names, looked up in the catalogue; shared by the verifiers of several types."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from probe.assets.library import Library
from probe.assets.spec import ObjectSpec
from probe.tasks.task import Task


def no_slots(task: Task, library: Library) -> Mapping[str, str]:
    """What fills the slots of wordings that have none."""
    return {}


def spec_of(task: Task, instance: int, library: Library) -> ObjectSpec:
    """What the catalogue says of an instance."""
    return library[task.scene[instance].object_id]


def instances_called(name: str, task: Task, library: Library) -> Sequence[int]:
    """Instances on a task's table whose name in the catalogue is this one."""
    known = {spec.id: spec.name for spec in library.specs}
    return [o.instance for o in task.scene.objects if known.get(o.object_id) == name]


def subject_is(task: Task, subject: str) -> Iterator[str]:
    """That a task's subject is these words."""
    if task.subject != subject:
        yield f"its subject is {ascii(task.subject)}, not {ascii(subject)}"


def no_subject(task: Task, library: Library) -> Iterator[str]:
    """That a task has no subject: which thing it is about is said by the options alone."""
    yield from subject_is(task, "")
