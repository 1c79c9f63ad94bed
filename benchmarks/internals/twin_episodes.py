"""How often the scripted agent is right on a robot's twin, behind a real bridge.

`python benchmarks/internals/twin_episodes.py --help`. Measures internals, not the public API.

Eight tasks of the suite `behind` and seven Beneath of `v1.1`, all seen by the front camera. Each
run has a robot of its own, whose cameras hang a little askew. They are corrected first, with a
plain box that the arm holds up, as `probe robot check --corrected` does it (`--uncorrected` leaves
that out); then the robot works at each task's table. What the agent sees with comes from an
enrolment of the task's objects and as many others as make 25, each shown alone before the same
camera. No label gets to the agent's side of the bridge. Finished episodes are kept, and their
pictures; those that a fault of ours ended are repeated by the next call. About a minute an
episode and two a task on one core, at a haste of 4.

`--simulated` plays the same tasks in the simulation, so that what each step costs can be told
apart: with its labels, and Beneath from above; with its labels, all from the front; and from the
front with what was enrolled, as on the twin.
"""

from __future__ import annotations

import time
from collections.abc import Sequence
from dataclasses import replace
from itertools import zip_longest
from pathlib import Path
from typing import Annotated, Literal

import numpy as np
import pydantic
import tyro
from rich.console import Console
from scipy.stats import binomtest

from probe.agents.scripted import Scripted
from probe.api.resources import cache_folder, everything
from probe.assets.library import Library
from probe.episodes.circumstances import Circumstances
from probe.episodes.episode import Episode
from probe.episodes.files import append_record, read_records
from probe.episodes.grading import question_of
from probe.episodes.perceptions import used_by
from probe.episodes.play import play as play_task
from probe.episodes.real import open_real_episode
from probe.episodes.record import EpisodeRecord
from probe.episodes.turns import Turn
from probe.errors import ProbeError
from probe.files import claim_folder
from probe.perception.choice import Enrolled, Perceiver, ideal
from probe.perception.enrolled.enrolment import EnrolledWords, Enrolment
from probe.perception.enrolled.enrolment_file import enrolment_of
from probe.perception.enrolled.simulated import enrol_simulated
from probe.render.renderer import Renderer
from probe.robot_check.box import KnownBox
from probe.robot_check.checking import Wishes, check, kit_of
from probe.scene.seeds import generator
from probe.station.remote import RobotStation, connected
from probe.tasks.suite import spaced
from probe.tasks.suite_file import find_suite
from probe.tasks.task import Task
from probe.twin.flaws import NO_FLAWS, Flaws
from probe.twin.only_box import BoxLibrary, box_scene
from probe.twin.serving import TwinSettings, listening, twin_of

ENROLLED = 25
BEHIND, BENEATH = 8, 7
TRIES = 3
"""Of an episode that a fault ends, as in a session on a robot: docs/how-to/robot-session.md."""

TOKEN = "known-to-this-process-alone"

Without = Literal["depth", "calibration", "colours", "losses"]
Simulated = Literal["no", "above", "front", "enrolled"]
out = Console()


class TwinSetting(pydantic.BaseModel, extra="forbid"):
    """What all episodes of a folder have in common; they couldn't be told apart otherwise."""

    without: tuple[Without, ...]
    perfect: bool
    simulated: Simulated
    uncorrected: bool


def flaws_without(switched_off: Sequence[Without], *, perfect: bool) -> Flaws:
    """The usual flaws, some of them switched off."""
    flaws = NO_FLAWS if perfect else Flaws()
    off = {
        "depth": {"depth_noise": 0.0, "depth_step": 1e-4, "holes": 0.0},
        "calibration": {"shift": 0.0, "turn": 0.0},
        "colours": {"colour_noise": 0.0},
        "losses": {"latency": 0.0, "dropped": 0.0},
    }
    for name in switched_off:
        flaws = replace(flaws, **off[name])
    return flaws


def enrolment_for(task: Task, things: Library, renderer: Renderer) -> Enrolment:
    """The task's objects and others, in a drawn order, shown to the task's camera."""
    mine = list(dict.fromkeys(placed.object_id for placed in task.scene.objects))
    named = {things[known].name for known in mine}
    rng = generator(task.seed, "enrolment")
    others = [s.id for s in things.specs if s.id.startswith("proc_") and s.name not in named]
    more = rng.choice(others, max(0, ENROLLED - len(mine)), replace=False).tolist()
    shown = [*mine, *more]
    camera = task.viewpoint.camera
    signatures = enrol_simulated(renderer, things, shown, camera, task.scene.table)
    known = {
        EnrolledWords(things[name].name, description=things[name].description): views
        for name, views in signatures.items()
    }
    return enrolment_of(known)


def play(task: Task, run: int, episode: Episode) -> EpisodeRecord:
    """Let the scripted agent work."""
    rng = generator(task.seed, "twin", run)
    agent = Scripted(task.question_type, task.subject, rng, form=task.form, bold=True)
    question, history = question_of(task), list[Turn]()
    while not episode.ended:
        call = agent.act(question, tuple(history))
        if call is None:
            break
        history.append(episode.step(call))
        out.print(f"  {call.name} {call.arguments}", highlight=False)
        out.print(f"    {history[-1].result.text[:300]}", highlight=False, markup=False)
    return episode.record


def one(
    task: Task,
    run: int,
    perceiver: Enrolled,
    things: Library,
    renderer: Renderer,
    settings: TwinSettings,
    folder: Path,
    *,
    film: bool,
) -> EpisodeRecord:
    """An episode on a fresh twin."""
    with (
        twin_of(task.scene, things, renderer, settings) as robot,
        listening(robot, TOKEN, "127.0.0.1", 0) as address,
    ):
        client = connected(address, TOKEN)
        try:
            station = RobotStation(client, task.setup, task.camera)
            keeps = station.film if film else None
            episode = open_real_episode(task, "scripted", station, perceiver, folder, run, keeps)
            return play(task, run, episode)
        finally:
            client.close()


def cameras_of(settings: TwinSettings, task: Task, renderer: Renderer, folder: Path) -> Path:
    """A file that tells where this robot's cameras stand, found with the box if it isn't there."""
    path = folder / f"cameras-{settings.seed}.json"
    if path.exists():
        return path
    box = KnownBox()
    scene, things = box_scene(task.setup, settings.seed), BoxLibrary(box.size, cache_folder())
    with (
        twin_of(scene, things, renderer, settings) as robot,
        listening(robot, TOKEN, "127.0.0.1", 0) as address,
    ):
        kit = kit_of(
            address, TOKEN, None, lambda found: out.print(f"  {found.check}: {found.text}")
        )
        check(kit, Wishes(task.setup, box, corrected=path), lambda text: True)
    return path


def chosen() -> list[Task]:
    """The tasks, each seen by the front camera, the two types in turns."""
    behind = spaced(find_suite("behind").tasks, BEHIND)
    flat = [task for task in find_suite("v1.1").tasks if task.question_type == "beneath"]
    beneath = [replace(task, camera="front") for task in spaced(flat, BENEATH)]
    return [task for pair in zip_longest(behind, beneath) for task in pair if task is not None]


def main(
    folder: Annotated[Path, tyro.conf.Positional],
    tasks: int = BEHIND + BENEATH,
    runs: tuple[int, ...] = (0, 1, 2),
    without: tuple[Without, ...] = (),
    perfect: bool = False,
    simulated: Simulated = "no",
    uncorrected: bool = False,
    haste: float = 4.0,
    film: bool = False,
) -> None:
    """Play the episodes that a folder lacks, and print how many are right.

    Args:
        folder: For records and pictures.
        tasks: The first how many of them.
        runs: Of each task; several calls can share the folder if their runs differ.
        without: Flaws to switch off.
        perfect: Switch all of them off.
        simulated: In the simulation instead; all but the last see by its labels.
        uncorrected: Leave the cameras as they were meant to stand.
        haste: How much faster than a real robot the twin is.
        film: Keep pictures of the arm in motion as well; they slow a busy machine's twin down.
    """
    setting = TwinSetting(
        without=tuple(sorted(without)),
        perfect=perfect,
        simulated=simulated,
        uncorrected=uncorrected,
    )
    claim_folder(folder / "setting.json", setting, "Choose another folder")
    records = folder / "records.jsonl"
    tried = list(read_records(records)) if records.exists() else []
    things, asked = everything(), chosen()[:tasks]
    flaws = flaws_without(without, perfect=perfect)
    with Renderer(things.light_cache) as renderer:
        for task in asked:
            perceiver: Enrolled | None = None
            for run in runs:
                mine = [r for r in tried if (r.task, r.run) == (task.id, run)]
                if len(mine) >= TRIES or any(r.fault is None for r in mine):
                    continue
                out.print(f"{task.id}, run {run}: {task.question} {task.answer}", highlight=False)
                begun = time.monotonic()
                try:
                    if perceiver is None and simulated in ("no", "enrolled"):
                        perceiver = Enrolled(enrolment_for(task, things, renderer))
                    if simulated != "no":
                        seen = from_above(task) if simulated == "above" else task
                        record = in_simulation(seen, run, things, renderer, perceiver or ideal)
                    else:
                        assert perceiver is not None
                        settings = TwinSettings(flaws, haste, run, ("front",))
                        if (flaws.shift or flaws.turn) and not uncorrected:
                            cameras = cameras_of(settings, task, renderer, folder)
                            settings = replace(settings, cameras=cameras)
                        record = one(
                            task, run, perceiver, things, renderer, settings, folder, film=film
                        )
                except ProbeError as error:
                    out.print(f"  not begun: {error}")
                    continue
                append_record(records, record)
                tried.append(record)
                said = record.answer.choice if record.answer else None
                out.print(f"  said {said}, {record.end}, {time.monotonic() - begun:.0f} s")
    summary(asked, runs, tried)


def from_above(task: Task) -> Task:
    """The task as the top camera shows it, if it can be asked so."""
    return task if task.question_type == "behind" else replace(task, camera="top")


def in_simulation(
    task: Task, run: int, things: Library, renderer: Renderer, perceiver: Perceiver
) -> EpisodeRecord:
    """The same agent at the same task without a robot."""
    rng = generator(task.seed, "twin", run)
    agent = Scripted(task.question_type, task.subject, rng, form=task.form, bold=True)
    tried = Circumstances(run=run, perception=used_by(perceiver))
    return play_task(
        task, agent, "scripted", things, renderer, tried, pictures=True, perceiver=perceiver
    )


def summary(asked: Sequence[Task], runs: Sequence[int], tried: Sequence[EpisodeRecord]) -> None:
    """Print how many were right, how the others ended, and how many a fault of ours ended."""
    tasks = {task.id: task for task in asked}
    mine = [r for r in tried if r.task in tasks and r.run in runs]
    played = [(tasks[r.task], r) for r in mine if r.fault is None]
    right = [r.answer is not None and r.answer.choice == task.answer for task, r in played]
    low, high = binomtest(sum(right), len(right)).proportion_ci(method="wilson")
    out.print(f"right {sum(right)} of {len(right)} ({low:.0%} to {high:.0%})")
    for ok, (task, record) in zip(right, played, strict=True):
        if not ok:
            said = record.answer.choice if record.answer else record.end
            out.print(f"  {task.id}, run {record.run}: {said} for {task.answer}", highlight=False)
    missing = len(tasks) * len(runs) - len(played)
    out.print(f"interrupted {len(mine) - len(played)}, and {missing} without a result")
    for record in mine:
        if record.fault is not None:
            out.print(f"  {record.task}, run {record.run}: {record.fault}", highlight=False)
    out.print(f"manipulations: {np.mean([record.manipulations for _, record in played]):.1f}")


if __name__ == "__main__":
    tyro.cli(main)
