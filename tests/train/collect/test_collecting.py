"""Collecting with tasks made by hand and a teacher whose answers are known."""

from __future__ import annotations

import shutil
from dataclasses import dataclass, field, replace
from functools import partial
from pathlib import Path

import pytest

from lessons import BY_KIND, FIRST_SEED, lesson
from probe.assets.library import Library, open_library
from probe.episodes.files import append_record, read_records, set_aside_cut
from probe.episodes.folder import RECORDS, SUITE
from probe.errors import BadData, Unsatisfiable
from probe.generation.build_folder import BuildFolder, CandidateLog, TaskSlot
from probe.generation.plan import ATTEMPTS
from probe.report.scene_renderer import SceneRenderer
from probe.tasks.suite_file import write_suite
from probe.train.choose.gathering import candidates_of
from probe.train.collect.aim import Aim
from probe.train.collect.batches import TASKS, batches
from probe.train.collect.collecting import TeacherWorkers, collect
from probe.train.collect.settings import CollectionSettings, claim

FIRST = 2_000_000
SETTINGS = CollectionSettings(
    agent="mine", pool="procedural", split=None, points="0-1000", graphs="short", noise="none",
    lighting="ambient", shard="0/1", first=FIRST,
)  # fmt: skip


@dataclass
class World:
    """Makes tasks of one kind and plays them: right if the place's number is even.

    Attributes:
        made, played: What was done, in order.
        stop_after: Episodes after which it is killed; None to go on.
        lost: A task and a setting whose episode leaves no record.
    """

    out: Path
    things: Library
    made: list[int] = field(default_factory=list)
    played: list[tuple[str, str]] = field(default_factory=list)
    stop_after: int | None = None
    impossible: bool = False
    lost: tuple[str, str] = ("", "")

    def hands(self) -> TeacherWorkers:
        dark = partial(SceneRenderer, open_library=lambda: self.things)
        return TeacherWorkers(self.make, self.play, self.things, dark)

    def make(self, places):
        parts = BuildFolder(self.out / TASKS)
        for place in places:
            if self.impossible:
                yield place, "no luck"
                continue
            if not parts.task_path(place).exists():
                self.made.append(place.episode)
                parts.keep(place, counting_task(place.episode - FIRST), self.things)
            yield place, None

    def play(self, suite, setting, runs, out):
        write_suite(out / SUITE, suite)
        path = out / RECORDS
        done = {it.task for it in read_records(path)} if path.exists() else set()
        for task in suite.tasks:
            if task.id in done:
                continue
            if self.stop_after is not None and len(self.played) >= self.stop_after:
                raise KeyboardInterrupt
            self.played.append((task.id, setting))
            if (task.id, setting) == self.lost:
                continue
            number = (task.seed - FIRST_SEED) // 1000
            right = number % (4 if setting == "direct" else 2) == 0
            append_record(path, lesson(task, setting=setting, right=right).record)
            yield task.id


@pytest.fixture
def things(cache):
    return open_library("procedural", None, cache)


def counting_task(number):
    """One of the demo's, with a training seed."""
    return replace(BY_KIND["count"], id=f"count-{number:08x}", seed=FIRST_SEED + 1000 * number)


def run(world, aim):
    return list(collect(world.out, aim, world.hands()))[-1].so_far


AIM = Aim({"count": 5}, FIRST, batch=4)


def test_it_goes_on_until_enough_are_right(tmp_path, things):
    world = World(tmp_path, things)
    so_far = run(world, AIM)
    assert so_far.successes["count"] >= 5 and AIM.reached(so_far) == 5
    # Every second one is right, in batches of at most four.
    assert so_far.tasks["count"] <= 12
    assert world.made == list(range(FIRST, FIRST + so_far.tasks["count"]))


def test_tools_are_used_only_where_the_picture_was_not_enough(tmp_path, things):
    world = World(tmp_path, things)
    run(world, AIM)
    direct = [task for task, setting in world.played if setting == "direct"]
    agentic = [task for task, setting in world.played if setting == "agentic"]
    assert len(set(direct)) == len(direct)
    assert set(agentic) == {task for task in direct if int(task.split("-")[1], 16) % 4}
    always = World(tmp_path / "always", things)
    run(always, Aim({"count": 2}, FIRST, batch=4, always=True))
    assert {setting for _, setting in always.played} == {"direct", "agentic"}
    assert len({task for task, _ in always.played}) * 2 == len(always.played)


def test_a_model_without_sight_plays_with_tools_alone(tmp_path, things):
    world = World(tmp_path, things)
    aim = Aim({"count": 2}, FIRST, batch=4, mode="text-only")
    so_far = run(world, aim)
    assert {setting for _, setting in world.played} == {"text-only"}
    assert so_far.played == {"text-only": len(world.made)} and aim.reached(so_far) == 2
    claim(tmp_path, SETTINGS)
    found, _ = candidates_of([tmp_path], {})
    assert {it.record.setting for it in found} == {"text-only"} and len(found) == len(world.made)


@pytest.mark.parametrize("other", [{"mode": "agentic"}, {"direct_runs": 1}])
def test_a_batch_is_not_finished_in_other_settings_than_it_was_begun_in(tmp_path, things, other):
    """What was played of it would stay ungraded, and nothing could be selected."""
    begun = Aim({"count": 5}, FIRST, batch=4, direct_runs=2)
    with pytest.raises(KeyboardInterrupt):
        run(TwiceDirect(tmp_path, things, stop_after=6), begun)
    (batch,) = batches(tmp_path)
    with pytest.raises(
        BadData, match=r"direct and agentic, 2 runs each. Say --settings and --direct-runs"
    ):
        run(World(tmp_path, things), replace(begun, **other))
    assert not batch.whole
    run(TwiceDirect(tmp_path, things), begun)
    assert batch.whole


def test_a_record_that_was_cut_off_is_left_to_whoever_plays_on(tmp_path, things):
    world = World(tmp_path, things, stop_after=2)
    with pytest.raises(KeyboardInterrupt):
        run(world, AIM)
    (batch,) = batches(tmp_path)
    path = batch.setting("direct") / RECORDS
    whole = path.read_bytes()
    path.write_bytes(whole + b'{"task": "half a li')
    played = CutAside(tmp_path, things)
    assert run(played, AIM).successes["count"] >= 5 and played.aside


class CutAside(World):
    """Sets aside what was cut off before it plays, as runs do."""

    aside = False

    def play(self, suite, setting, runs, out):
        if (out / RECORDS).exists():
            self.aside = set_aside_cut(out / RECORDS) is not None or self.aside
        yield from super().play(suite, setting, runs, out)


class TwiceDirect(World):
    """Plays two runs without tools."""

    def play(self, suite, setting, runs, out):
        yield from super().play(suite, setting, runs, out)
        path = out / RECORDS
        for task in suite.tasks if setting == "direct" else ():
            append_record(path, lesson(task, setting=setting, run=1).record)


def test_a_place_that_was_tried_in_vain_is_left_out(tmp_path, things):
    parts = BuildFolder(tmp_path / TASKS)
    for attempt in range(ATTEMPTS):
        tried = CandidateLog("count", 1000 * FIRST + attempt, "hidden", None, "in sight", 1.0)
        parts.add(TaskSlot("count", FIRST), tried)
    world = World(tmp_path, things)
    run(world, Aim({"count": 1}, FIRST, batch=1))
    assert world.made[0] == FIRST + 1


@pytest.mark.parametrize("stop", [0, 3, 5, 8])
def test_a_killed_one_goes_on_and_does_nothing_twice(tmp_path, things, stop):
    whole = World(tmp_path / "whole", things)
    run(whole, AIM)
    world = World(tmp_path / "cut", things, stop_after=stop)
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


def test_a_finished_one_has_nothing_to_do(tmp_path, things):
    run(World(tmp_path, things), AIM)
    again = World(tmp_path, things)
    run(again, AIM)
    assert again.made == again.played == []


def test_a_budget_ends_it(tmp_path, things):
    world = World(tmp_path, things)
    aim = Aim({"count": 100}, FIRST, batch=4, most_episodes=13)
    so_far = run(world, aim)
    assert so_far.episodes <= 13 and aim.spent(so_far) == "episodes"
    money = World(tmp_path / "money", things)
    aim = Aim({"count": 100}, FIRST, batch=4, most_cost=2.0)
    so_far = run(money, aim)
    assert 1.0 <= so_far.cost <= 2.0 and aim.spent(so_far) == "cost"


def test_an_episode_that_left_no_record_is_missing(tmp_path, things):
    world = World(tmp_path, things, lost=(counting_task(1).id, "direct"))
    so_far = run(world, AIM)
    assert so_far.missing == 1
    # It isn't known from the picture, so that tools are tried.
    assert (counting_task(1).id, "agentic") in world.played
    assert so_far.tasks["count"] == len(world.made)


def test_a_batch_after_a_deleted_one_overwrites_none(tmp_path, things):
    run(World(tmp_path, things), Aim({"count": 5}, FIRST, batch=4))
    _, second, third = batches(tmp_path)
    kept = {path: path.read_bytes() for path in third.folder.rglob("*") if path.is_file()}
    shutil.rmtree(second.folder)
    run(World(tmp_path, things), Aim({"count": 7}, FIRST, batch=4))
    assert kept == {path: path.read_bytes() for path in kept}
    assert [it.folder.name[-1] for it in batches(tmp_path)][:3] == ["0", "2", "3"]


def test_what_was_missing_may_be_right_once_it_goes_on(tmp_path, things):
    """The task is played with tools by then, since nothing was known of it without."""
    world = World(tmp_path, things, lost=(counting_task(4).id, "direct"), stop_after=12)
    with pytest.raises(KeyboardInterrupt):
        run(world, AIM)
    assert world.played[-1] == (counting_task(4).id, "agentic")
    world.stop_after, world.lost = None, ("", "")
    so_far = run(world, AIM)
    assert AIM.reached(so_far) == 5 and so_far.missing == 0
    assert world.played.count((counting_task(4).id, "direct")) == 2


def test_tasks_that_cannot_be_made_are_told(tmp_path, things):
    with pytest.raises(Unsatisfiable, match="None of 4 tasks could be made. no luck"):
        run(World(tmp_path, things, impossible=True), AIM)
    assert batches(tmp_path) == []
