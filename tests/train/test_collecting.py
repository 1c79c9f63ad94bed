"""Collecting with tasks made by hand and a teacher whose answers are known."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
import pytest

from lessons import lesson, suite_of, training_task
from probe.certify.parts import Parts
from probe.episodes.files import append_record, read_records
from probe.episodes.folder import RECORDS, SUITE
from probe.episodes.grading import grade_episode
from probe.errors import Unsatisfiable
from probe.tasks.suite import Suite
from probe.tasks.suite_file import read_suite, write_suite
from probe.train.aim import Aim
from probe.train.batches import TASKS, batches
from probe.train.collecting import Hands, collect

FIRST = 2_000_000


class Letters:
    """Grades by the letter; these tasks need no pictures."""

    def __init__(self, suite: Suite) -> None: ...

    def __enter__(self):
        return self

    def __exit__(self, *raised): ...

    def score(self, task, record):
        return grade_episode(task, record, np.zeros((0, 0), np.int32))


@dataclass
class World:
    """Makes tasks of one kind and plays them: right if the place's number is even.

    Attributes:
        made, played: What was done, in order.
        stop_after: Episodes after which it is killed; None to go on.
    """

    out: Path
    made: list[int] = field(default_factory=list)
    played: list[tuple[str, str]] = field(default_factory=list)
    stop_after: int | None = None
    impossible: bool = False

    def hands(self) -> Hands:
        return Hands(self.make, self.play, None, Letters)  # type: ignore[arg-type]

    def make(self, places):
        parts = Parts(self.out / TASKS)
        for place in places:
            if self.impossible:
                yield place, "no luck"
                continue
            if not parts.task_path(place).exists():
                self.made.append(place.episode)
                task = training_task(place.episode - FIRST, "count")
                write_suite(parts.task_path(place), suite_of([task], f"count-{place.episode}"))
            yield place, None

    def play(self, suite, arm, runs, out):
        write_suite(out / SUITE, suite)
        path = out / RECORDS
        done = {it.task for it in read_records(path)} if path.exists() else set()
        for task in suite.tasks:
            if task.id in done:
                continue
            if self.stop_after is not None and len(self.played) >= self.stop_after:
                raise KeyboardInterrupt
            self.played.append((task.id, arm))
            number = (task.seed - 2_000_000_000) // 1000
            right = number % 2 == 0 if arm == "agentic" else number % 4 == 0
            append_record(path, lesson(task, arm=arm, right=right).record)
            yield task.id


@pytest.fixture(autouse=True)
def by_hand(monkeypatch):
    """Objects of these tasks have no bodies to take fingerprints of."""
    monkeypatch.setattr("probe.train.collecting.check_objects", lambda suite, things: None)

    def assembled(path, parts, places, library):
        tasks = [task for place in places for task in read_suite(parts.task_path(place)).tasks]
        write_suite(path, suite_of(tasks, path.stem))

    monkeypatch.setattr("probe.train.collecting.assemble", assembled)


def run(world, aim):
    return list(collect(world.out, aim, world.hands()))[-1].so_far


AIM = Aim({"count": 5}, FIRST, batch=4)


def test_it_goes_on_until_enough_are_right(tmp_path):
    world = World(tmp_path)
    so_far = run(world, AIM)
    assert so_far.successes["count"] >= 5 and AIM.reached(so_far) == 5
    # Every second one is right, in batches of at most four.
    assert so_far.tasks["count"] <= 12
    assert world.made == list(range(FIRST, FIRST + so_far.tasks["count"]))


def test_tools_are_used_only_where_the_picture_was_not_enough(tmp_path):
    world = World(tmp_path)
    run(world, AIM)
    direct = [task for task, arm in world.played if arm == "direct"]
    agentic = [task for task, arm in world.played if arm == "agentic"]
    assert len(set(direct)) == len(direct)
    assert set(agentic) == {task for task in direct if int(task.split("-")[1], 16) % 4}
    always = World(tmp_path / "always")
    run(always, Aim({"count": 2}, FIRST, batch=4, always=True))
    assert {arm for _, arm in always.played} == {"direct", "agentic"}
    assert len({task for task, _ in always.played}) * 2 == len(always.played)


@pytest.mark.parametrize("stop", [0, 3, 5, 8])
def test_a_killed_one_goes_on_and_does_nothing_twice(tmp_path, stop):
    whole = World(tmp_path / "whole")
    run(whole, AIM)
    world = World(tmp_path / "cut", stop_after=stop)
    with pytest.raises(KeyboardInterrupt):
        run(world, AIM)
    world.stop_after = None
    so_far = run(world, AIM)
    assert AIM.reached(so_far) == 5
    assert (world.made, world.played) == (whole.made, whole.played)
    first, second = (
        sorted((it.relative_to(w.out), it.read_bytes()) for it in w.out.rglob("*.json*"))
        for w in (whole, world)
    )
    assert first == second


def test_a_finished_one_has_nothing_to_do(tmp_path):
    run(World(tmp_path), AIM)
    again = World(tmp_path)
    run(again, AIM)
    assert again.made == again.played == []


def test_a_budget_ends_it(tmp_path):
    world = World(tmp_path)
    aim = Aim({"count": 100}, FIRST, batch=4, most_episodes=13)
    so_far = run(world, aim)
    assert so_far.episodes <= 13 and aim.spent(so_far) == "episodes"
    money = World(tmp_path / "money")
    aim = Aim({"count": 100}, FIRST, batch=4, most_cost=2.0)
    so_far = run(money, aim)
    assert 1.0 <= so_far.cost <= 2.0 and aim.spent(so_far) == "cost"


def test_tasks_that_cannot_be_made_are_told(tmp_path):
    with pytest.raises(Unsatisfiable, match="None of 4 tasks could be made. no luck"):
        run(World(tmp_path, impossible=True), AIM)
    assert batches(tmp_path) == []
