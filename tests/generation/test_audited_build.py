"""A task that is measured once more and doesn't hold isn't kept; the next candidate is."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import pytest

from probe.assets.library import Library, open_library
from probe.assets.tables import table_ids
from probe.generation.attempt import Attempt
from probe.generation.build import BuildResources, fill
from probe.generation.build_folder import KEPT, UNVERIFIED, BuildFolder, TaskSlot
from probe.generation.generate import make
from probe.generation.result import TaskCandidate
from probe.render.renderer import Renderer
from probe.tasks.suite_file import read_suite
from probe.tasks.task import Task
from probe.verification.check import what_is_wrong

pytestmark = pytest.mark.slow
PLACE = TaskSlot("count", 0)


def test_a_task_that_fails_it_is_not_kept(library: Library, renderer: Renderer, tmp_path):
    seen = list[Task]()

    def once(task: Task, things: Library, renderer: Renderer) -> Mapping[str, Sequence[str]]:
        seen.append(task)
        wrong = {"hidden": ["it shows", "by far"]}
        return wrong if len(seen) == 1 else what_is_wrong(task, things, renderer)

    parts = BuildFolder(tmp_path / "made.parts")
    resources = BuildResources(library, table_ids(None), renderer, audit=once)
    *rejected, kept = fill(PLACE, parts, resources)
    (refused,) = (it for it in rejected if it.check == UNVERIFIED)
    assert (refused.seed, refused.detail) == (seen[0].seed, "hidden: it shows; hidden: by far")
    (task,) = read_suite(parts.task_path(PLACE)).tasks
    assert kept.check == KEPT and task.seed == seen[-1].seed != seen[0].seed
    assert what_is_wrong(task, library, renderer) == {}


def test_a_measurement_that_comes_out_otherwise_is_found(cache, renderer):
    """Its generator measured that no other thing gains 20% once the cover is gone."""
    library = open_library("evaluation", None, cache)
    attempt = Attempt(TaskSlot("relation", 50003), 0, None)
    made = make(attempt, library, renderer, table_ids(None))
    assert isinstance(made, TaskCandidate)
    wrong = what_is_wrong(made.task, library, renderer)
    assert wrong.keys() == {"hidden"} and "(resettled) another thing gains 2" in wrong["hidden"][0]
