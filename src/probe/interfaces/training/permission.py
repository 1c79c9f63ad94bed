"""Which tasks a trainer may have: none that a model is evaluated on."""

from __future__ import annotations

from collections import defaultdict

from probe.assets.pools.division import divided
from probe.assets.pools.split import Split
from probe.errors import ProbeError
from probe.tasks.suite import Suite
from probe.tasks.suite_file import packaged_suite, packaged_suites
from probe.train.choose.evaluation import Evaluation, TrainingRefusal, evaluation_of
from probe.train.collect.training import FIRST_EPISODE


class NotForTraining(ProbeError):
    """A task belongs to evaluation; the message says why."""

    def __init__(self, suite: str, refusal: TrainingRefusal) -> None:
        super().__init__(
            f"{suite}: {refusal.task} is no task to train on ({refusal.leak}: {refusal.detail}). "
            "Make tasks for training with `probe suite build FILE.json --public --first "
            f"{FIRST_EPISODE} --unchecked --pool train`, or say evaluation=True to measure only."
        )


def check_for_training(suite: Suite) -> None:
    """Refuse a suite with a task of evaluation; see probe.train.choose.evaluation.

    Tasks, seeds and scenes of the package's suites are refused, and built-in objects of the pool
    for evaluation; of all others, such as scans, nobody knows what they are for.

    Raises:
        NotForTraining: One is; the first is named.
    """
    kept = _evaluation()
    for task in suite.tasks:
        if refusal := kept.refusal(task):
            raise NotForTraining(suite.name, refusal)


def _evaluation() -> Evaluation:
    """All that the package keeps for evaluation."""
    rows = divided().values()
    groups = defaultdict[str, list[str]](list)
    for row in rows:
        groups[row.group].append(row.id)
    split = Split(parts={row.id: row.part for row in rows})
    return evaluation_of([packaged_suite(it) for it in packaged_suites()], split, groups.values())
