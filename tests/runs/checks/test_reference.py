"""A folder's suite beside the one that somebody has in hand."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from forgeries import honest
from probe.episodes.conditions import Conditions
from probe.errors import BadData
from probe.runs.checks.reference import check_reference
from probe.runs.variation import Variation, digest_of_tasks, write_variation
from probe.tasks.suite import Suite, selection
from run_folders import DEMO

MINE = replace(DEMO, name="mine", commitment="0" * 64)
OTHER = replace(DEMO.tasks[0], answer="A" if DEMO.tasks[0].answer != "A" else "B")
OBJECT = next(iter(DEMO.objects))

UNLIKE: dict[str, tuple[Suite, str]] = {
    "another name": (replace(MINE, name="mine "), 'it is called "mine "'),
    "another salt": (replace(MINE, commitment=None), "it is committed to another salt"),
    "a part": (replace(selection(MINE, MINE.tasks[:2], "mine"), objects=MINE.objects), "it has 2"),
    "another order": (replace(MINE, tasks=MINE.tasks[::-1]), "its tasks stand in another order"),
    "another answer": (
        replace(MINE, tasks=(OTHER, *MINE.tasks[1:])),
        f"task {OTHER.id} is another one there: its answer differs",
    ),
    "another object": (
        replace(MINE, objects={**MINE.objects, OBJECT: (0.0,)}),
        f"the fingerprint of {OBJECT} is another one there",
    ),
    "fewer objects": (
        replace(MINE, objects={k: v for k, v in MINE.objects.items() if k != OBJECT}),
        "fingerprints of other objects",
    ),
}


def test_the_very_suite_passes(tmp_path: Path):
    check_reference(tmp_path, MINE, replace(MINE, objects=dict(MINE.objects)), [])


@pytest.mark.parametrize("name", UNLIKE)
def test_any_other_is_refused(tmp_path: Path, name: str):
    suite, words = UNLIKE[name]
    with pytest.raises(BadData, match=r"suite\.json: isn't the suite mine that --suite names"):
        check_reference(tmp_path, suite, MINE, [])
    with pytest.raises(BadData, match=words):
        check_reference(tmp_path, suite, MINE, [])


def test_under_other_conditions_tasks_have_to_come_from_it(tmp_path: Path):
    conditions = Conditions(pose_jitter=0.01)
    records = [replace(honest(), conditions=conditions)]
    base = digest_of_tasks(MINE.tasks)
    write_variation(tmp_path, Variation(base=base, conditions=conditions.label, notes={}))
    check_reference(tmp_path, MINE, MINE, records)
    with pytest.raises(BadData, match="its answer differs"):
        check_reference(tmp_path, UNLIKE["another answer"][0], MINE, records)
    write_variation(tmp_path, Variation(base="0" * 64, conditions=conditions.label, notes={}))
    with pytest.raises(BadData, match="its tasks were made from others"):
        check_reference(tmp_path, MINE, MINE, records)
