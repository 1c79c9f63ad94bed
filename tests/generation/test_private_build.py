"""A private task, really made: from its salt alone, and with nothing of it in the suite."""

from __future__ import annotations

import pytest

from probe.assets.library import Library
from probe.assets.tables import table_ids
from probe.errors import BadData
from probe.generation.attempt import Attempt, origins
from probe.generation.build import BuildResources, assemble, fill
from probe.generation.build_folder import KEPT, BuildFolder, TaskSlot
from probe.generation.plan import plan_of
from probe.generation.salt import Salt
from probe.render.renderer import Renderer
from probe.tasks.suite_file import read_suite
from probe.verification.check import rebuild_problem
from probe.verification.salt import salt_problems
from probe.verification.text import read_anew

pytestmark = pytest.mark.slow
ONE, OTHER = Salt(bytes(range(32))), Salt(bytes(range(1, 33)))
PLACE = TaskSlot("count", 0)


@pytest.fixture(scope="module")
def made(library: Library, renderer: Renderer, tmp_path_factory) -> BuildFolder:
    parts = BuildFolder(tmp_path_factory.mktemp("made.parts"))
    resources = BuildResources(library, table_ids(None), renderer, salt=ONE)
    *rejected, kept = fill(PLACE, parts, resources)
    assert kept.check == KEPT and all(line.check != KEPT for line in rejected)
    return parts


def test_it_comes_out_of_its_salt_again_and_out_of_no_other(made, library, renderer):
    path = made.folder / "made.json"
    assemble(path, made, [PLACE], library, ONE)
    suite = read_suite(path)
    (task,) = suite.tasks
    found = origins(suite.tasks, ONE)
    assert suite.commitment == ONE.commitment
    assert list(salt_problems(suite, found)) == [] and read_anew(task, library) == ()
    assert task.answer == plan_of("count", 0, ONE).letter
    attempt = found[task.id]
    text = path.read_text()
    for secret in (str(attempt.seed), ONE.secret.hex(), "count-0"):
        assert secret not in text
    assert rebuild_problem(task, library, renderer, table_ids(None), attempt) is None
    other = Attempt(attempt.place, attempt.number, OTHER)
    assert rebuild_problem(task, library, renderer, table_ids(None), other) is not None


def test_what_was_begun_goes_on_and_a_part_of_another_salt_is_refused(made, library, renderer):
    resources = BuildResources(library, table_ids(None), renderer, salt=ONE)
    assert list(fill(PLACE, made, resources)) == []
    with pytest.raises(BadData, match=r"count-0\.json: was made with another salt.*Delete it"):
        assemble(made.folder / "other.json", made, [PLACE], library, OTHER)


def test_the_seed_that_it_bears_makes_another_task(made, library, renderer):
    (task,) = read_suite(made.task_path(PLACE)).tasks
    borne = Attempt.of_seed("count", task.seed)
    assert rebuild_problem(task, library, renderer, table_ids(None), borne) is not None
