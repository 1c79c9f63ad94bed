"""Which numbers a task of Count may offer, by which rules."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from probe.assets.library import Library
from probe.tasks.options import drop_one
from probe.tasks.suite_file import packaged_suite
from probe.tasks.task import RulesVersion, Task
from probe.verification.options import option_problems

COUNT = next(task for task in packaged_suite("v1").tasks if task.question_type == "count")


def counting(candidates: str, clear: int, version: RulesVersion) -> Task:
    """A task with one true thing and other candidates; so many are said to be clear."""
    drawn = tuple(candidates.split())
    measures = {**COUNT.certificate.measures, "clear": float(clear)}
    return replace(
        COUNT,
        targets=(COUNT.scene.objects[0].instance,),
        options=drop_one(drawn, drawn.index("1"), "B", np.random.default_rng(0)),
        answer="B",
        certificate=replace(COUNT.certificate, candidates=drawn, measures=measures),
        version=version,
    )


@pytest.mark.parametrize(
    ("candidates", "clear", "version", "problems"),
    [
        ("0 1 2 3 5", 1, 2, 0),
        ("0 1 2 3 6", 0, 2, 1),  # not to five
        ("1 2 3 4 6", 1, 3, 0),
        ("0 1 2 5 6", 0, 3, 0),
        ("0 1 2 3 6", 1, 3, 1),  # one on either side
        ("0 1 3 4 5", 1, 3, 1),  # two more of it missing
        ("0 1 2 3 7", 0, 3, 1),  # not to six
        ("1 0 2 3 4", 0, 2, 1),  # out of order
    ],
)
def test_numbers_are_those_of_the_rules(
    library: Library, candidates: str, clear: int, version: RulesVersion, problems: int
):
    found = list(option_problems(counting(candidates, clear, version), library))
    assert len(found) == problems, found
