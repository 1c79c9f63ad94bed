from __future__ import annotations

from dataclasses import replace

import pytest

from probe.assets.library import open_library
from probe.errors import BadData
from probe.scene.scene import PlacedObject, Scene
from probe.scene.setup import ROOM_TABLE
from probe.tasks.suite import Suite, check_objects, freeze
from probe.types import Pose
from task_examples import FIND

SCENE = Scene(1, "oak_planks", (PlacedObject(2, "proc_lime", Pose()),))


def test_a_library_that_differs_is_refused(cache):
    library = open_library("procedural", None, cache)
    suite = freeze("small", (replace(FIND, scene=SCENE, targets=(2,)),), library)
    assert set(suite.objects) == {"proc_lime"} and suite.pool == "procedural"
    check_objects(suite, library)
    lime = suite.objects["proc_lime"]
    with pytest.raises(BadData, match="proc_lime has changed since"):
        check_objects(replace(suite, objects={"proc_lime": (*lime[:-1], 0.9)}), library)
    with pytest.raises(BadData, match="there is no proc_unicorn here"):
        check_objects(replace(suite, objects={"proc_unicorn": ()}), library)


def test_a_suite_knows_its_objects_by_its_own_looks(cache):
    library = open_library("procedural", None, cache)
    old = replace(FIND, scene=SCENE, targets=(2,))
    new = replace(old, scene=replace(SCENE, setup=ROOM_TABLE))
    suites = [freeze("small", (task,), library) for task in (old, new)]
    for suite in suites:
        check_objects(suite, library)
    with pytest.raises(BadData, match="proc_lime has changed since"):
        check_objects(replace(suites[1], objects=suites[0].objects), library)


def test_a_suite_is_gone_through_task_by_task():
    other = replace(FIND, id="find-2")
    suite = Suite("small", (FIND, other), {})
    assert list(suite) == [FIND, other] and len(suite) == 2
    assert FIND in suite and suite["find-2"] == other
