"""First looks of many tasks, kept on disk: drawing them takes seconds each."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from contextlib import suppress
from pathlib import Path

import pydantic

from probe.assets.cache import content_key
from probe.assets.library import Library
from probe.files import write_bytes
from probe.generation.first_look import FirstLook, look_at
from probe.generation.necessary import is_answerable_at_sight
from probe.render.renderers import Renderers
from probe.shortcuts.sample import LabelledSample, example_of
from probe.tasks.suite import Suite, check_objects, part
from probe.tasks.task import Task

_LAYOUT = "3"
_DOCUMENT = pydantic.TypeAdapter(FirstLook)


def examples_of(suites: Iterable[Suite], library: Library, cache: Path) -> Iterator[LabelledSample]:
    """Every task of some suites once, as an example, in their order.

    Those that need no manipulation are left out: looking is what answers them.

    Args:
        suites: Of generated tasks.
        library: Has their objects.
        cache: Folder in which looks are kept.

    Raises:
        BadData: An object isn't what it was when its suite was made.
    """
    done = set[str]()
    with Renderers() as renderers:
        for suite in suites:
            for task in suite.tasks:
                if task.id not in done and not is_answerable_at_sight(task):
                    done.add(task.id)
                    yield example_of(task, _look(suite, task, library, renderers, cache))


def _look(
    suite: Suite, task: Task, library: Library, renderers: Renderers, cache: Path
) -> FirstLook:
    alone = part(suite, task)
    specs = [library[object_id] for object_id in sorted(alone.objects)]
    seen = map(repr, (task.scene, task.marks, alone.objects, specs))
    drawn_by = () if task.setup.renderer == "filament" else (task.setup.renderer,)
    key = content_key("look", _LAYOUT, *seen, *drawn_by)
    path = cache / "looks" / key[:2] / f"{key}.json"
    if path.exists():
        with suppress(pydantic.ValidationError):  # a damaged one is drawn again
            return _DOCUMENT.validate_json(path.read_bytes())
    check_objects(alone, library)
    look = look_at(task, library, renderers[task.setup.renderer])
    write_bytes(path, _DOCUMENT.dump_json(look))
    return look
