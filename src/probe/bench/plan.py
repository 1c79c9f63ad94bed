"""What a model is to be run on, and the folder that its records go to."""

from __future__ import annotations

import uuid
from collections.abc import Callable, Generator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Literal

from probe.assets.library import Library
from probe.bench.prices import Price, Prices
from probe.episodes.conditions import AS_FROZEN, Conditions
from probe.episodes.conventions import check_convention, claim_convention
from probe.episodes.files import line_of, read_records, set_aside_cut
from probe.episodes.folder import (
    RECORDS,
    check_for_agents,
    check_suite,
    occupied,
    standing,
)
from probe.episodes.noise import NO_NOISE, Noise
from probe.episodes.ordered import note_ordered
from probe.episodes.participation import Points
from probe.episodes.perceptions import used_by
from probe.episodes.record import EpisodeRecord
from probe.errors import BadData
from probe.files import write_text
from probe.perception.choice import Perceiver, ideal
from probe.perception.points import Convention
from probe.reading import words
from probe.runs.checks.folder import check_records
from probe.runs.plan import RunOrder
from probe.runs.run import check_settings
from probe.tasks.suite import Suite
from probe.tasks.task import Task
from probe.transcripts.prompts import Graphs, Setting, told_with

Pointer = Literal["oracle", "self", "role"]
"""Who points for perception: nobody, the model itself, or the one in the role "pointer"."""

REPLIES = "replies.id"
"""Beside the records: under which name replies are kept that needn't be paid again."""


@dataclass(frozen=True)
class ModelRunPlan:
    """What is to be run; a model takes the seat later.

    Attributes:
        setting: How it may answer.
        suite: What is asked.
        tasks: Of them, those that are run here.
        out: Folder for the records.
        library: Opens the objects; a value that can be sent to another process.
        cache: Folder for prepared light.
        epochs: Runs of each task.
        points: How the model counts places in pictures.
        graphs: How lists are told in the setting "text-only".
        noise: How far the hand errs.
        conditions: In what episodes differ from their tasks.
        pointer: Who points for perception.
        convention: How the one who points writes points down.
        workers: Tables, and so samples, at a time.
        prices: Of tokens.
        called: Name of the model in the records; by default the harness's.
        perceiver: What the tools see with, if nobody points.
        tables: Folder in which a page looks what happens at the tables; None for nobody.
    """

    setting: Setting
    suite: Suite
    tasks: tuple[Task, ...]
    out: Path
    library: Callable[[], Library]
    cache: Path | None = None
    epochs: int = 3
    points: Points = "pixels"
    noise: Noise = NO_NOISE
    conditions: Conditions = AS_FROZEN
    pointer: Pointer = "oracle"
    convention: Convention = "pixels"
    workers: int = 4
    prices: Prices = field(default_factory=dict[str, Price])
    called: str | None = None
    perceiver: Perceiver = ideal
    tables: Path | None = None
    graphs: Graphs = "full"

    @property
    def named_setting(self) -> str:
        """The setting as records name it, where nobody points."""
        return told_with(self.setting, self.graphs)

    def order(self, model: str, pointer: str) -> RunOrder:
        """Who acts, and under which conditions.

        Args:
            model: Name of the model.
            pointer: Name of the one that points; empty for nobody.
        """
        setting = f"{self.named_setting}, pointer {pointer}" if pointer else self.named_setting
        agent = self.called or model
        return RunOrder(
            agent,
            self.epochs,
            self.noise,
            self.conditions,
            setting=setting,
            points=self.points,
            perception=used_by(self.perceiver),
        )


Done = Mapping[tuple[str, int], bytes]
"""Lines of records that are there already, by task and run."""


@contextmanager
def taken_up(plan: ModelRunPlan, order: RunOrder) -> Generator[tuple[Done, str]]:
    """Make or take up the folder, for this process alone; nothing is changed if it is refused.

    Raises:
        BadData: See take_up; or another run is at work there.
        OutputFailed: It can't be written.
    """
    check_folder(plan, order)
    with occupied(plan.out, plan.suite):
        yield take_up(plan, order)


def check_folder(plan: ModelRunPlan, order: RunOrder) -> None:
    """See that a folder, if it is one, is about the same suite under the same conditions.

    Raises:
        BadData: It isn't, it is kept for people's records, or a record can't be of a run of the
            suite.
    """
    check_suite(plan.out, plan.suite)
    check_for_agents(plan.out)
    path = plan.out / RECORDS
    if path.exists():
        earlier = read_records(path, whole=False)
        check_settings(path, earlier, order)
        # The harness shows what they are worth beside what is played now.
        check_records(earlier, plan.suite, path)
    if plan.pointer != "oracle":
        check_convention(plan.out, order.agent, order.setting, plan.convention)


def missing_of(plan: ModelRunPlan, order: RunOrder) -> int:
    """How many episodes of a plan have no record that counts."""
    path = plan.out / RECORDS
    return lacking(plan, _done(read_records(path) if path.exists() else [], order))


def lacking(plan: ModelRunPlan, done: Done) -> int:
    """How many episodes of a plan are still to be done."""
    wanted = {(task.id, run) for task in plan.tasks for run in range(plan.epochs)}
    return len(wanted - done.keys())


def take_up(plan: ModelRunPlan, order: RunOrder) -> tuple[Done, str]:
    """Take up a folder of records, which no other process may write to meanwhile.

    Returns:
        What has been done before, and under which name replies are kept.

    Raises:
        BadData: It was run under other conditions, or can't be read.
        OutputFailed: It can't be written.
    """
    set_aside_cut(plan.out / RECORDS)
    path = plan.out / RECORDS
    earlier = read_records(path) if path.exists() else []
    check_settings(path, earlier, order)
    if plan.pointer != "oracle":
        claim_convention(plan.out, order.agent, order.setting, plan.convention)
    note_ordered(plan.out, order.agent, order.setting, order.runs)
    return _done(earlier, order), _name_of_replies(plan.out / REPLIES)


def _done(earlier: Sequence[EpisodeRecord], order: RunOrder) -> Done:
    mine = [it for it in earlier if (it.agent, it.setting) == (order.agent, order.setting)]
    return {(it.task, it.run): line_of(it) for it in standing(mine) if it.end != "fault"}


def _name_of_replies(path: Path) -> str:
    """Of this folder alone: a run in another one asks the model again."""
    if not path.exists():
        write_text(path, uuid.uuid4().hex + "\n")
    try:
        return words(path).strip()
    except (OSError, UnicodeDecodeError) as error:
        raise BadData(path, str(error), "Delete it; replies are then asked for again") from error
