"""Since rules 3, what a cover rests on is alike in all of its sides."""

from __future__ import annotations

from contextlib import suppress
from dataclasses import replace

import pytest

from probe.assets.library import Library
from probe.assets.spec import ObjectSpec
from probe.generation.object_selection import ObjectSelection
from probe.generation.plan import plan_of
from probe.generation.result import Rejected
from probe.generation.task_generator import generator_of
from probe.question_types.find.generator import PARTLY_SEEN
from probe.question_types.reduce.verifier import VERIFIER
from probe.scene.seeds import generator
from probe.tasks.suite_file import packaged_suite
from probe.tasks.task import RulesVersion
from probe.verification.options import depth_problems

pytestmark = pytest.mark.slow


def candidates(library: Library, question_type: str, rules: RulesVersion) -> list[list[ObjectSpec]]:
    """Of five tasks whose target is hidden; some seeds find nothing to cover it with."""
    found: list[list[ObjectSpec]] = []
    for episode in range(30):
        wanted = plan_of(question_type, episode, rules=rules)
        if question_type == "find":
            wanted = PARTLY_SEEN.put(wanted, False)
        rng = generator(episode, "cast")
        with suppress(Rejected):
            cast = generator_of(question_type).select(library, wanted, rng)
            assert isinstance(cast, ObjectSelection)
            found.append([*cast.candidates])
        if len(found) == 5:
            break
    assert len(found) == 5
    return found


def ratios(specs: list[ObjectSpec]) -> list[float]:
    """Largest by smallest, of shorter and longer side on the table, and of height."""
    sides = [(*sorted(spec.size[:2]), spec.size[2]) for spec in specs]
    return [max(values) / min(values) for values in zip(*sides, strict=True)]


@pytest.mark.parametrize("question_type", ["beneath", "find", "reduce"])
def test_candidates_are_alike_in_height_too(library: Library, question_type: str):
    for specs in candidates(library, question_type, 3):
        assert max(ratios(specs)) <= 1.1
    # By v1's rules, heights differ by much more: that is what told.
    assert max(ratios(specs)[2] for specs in candidates(library, question_type, 2)) > 1.5


def test_unlike_heights_are_found_in_tasks_of_the_new_rules_alone(library: Library):
    tasks = [t for t in packaged_suite("v1").tasks if t.question_type in ("beneath", "reduce")]
    assert not any(list(depth_problems(task, library)) for task in tasks)
    told = [list(depth_problems(replace(task, version=3), library)) for task in tasks]
    assert sum(map(bool, told)) > len(tasks) / 2
    assert "a side of its candidates differs by more than 10%" in {
        line for it in told for line in it
    }


def test_a_slab_that_tells_by_its_gap_is_found_in_tasks_of_the_new_rules_alone(library: Library):
    tasks = [task for task in packaged_suite("v1").tasks if task.question_type == "reduce"]
    uneven = "its candidates' heights differ by more than 1 mm"
    assert not any(uneven in VERIFIER.subject(task, library) for task in tasks)
    assert all(uneven in VERIFIER.subject(replace(task, version=3), library) for task in tasks)
