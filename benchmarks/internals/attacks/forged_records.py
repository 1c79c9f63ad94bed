"""Records that were played for real, forged: told by the checks, a replay, or a signature."""

from __future__ import annotations

import json
import shutil
import subprocess
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path

from command import probe, refusal
from verdict import Attack, some

from probe.audit.audit_file import AUDIT
from probe.episodes.files import read_records, write_records
from probe.episodes.folder import RECORDS, SUITE
from probe.episodes.noise import Noise
from probe.episodes.record import EpisodeRecord, Seconds, Step, TableState
from probe.episodes.turns import Call
from probe.scene.scene import Scene
from probe.tasks.suite import Suite
from probe.tasks.suite_file import read_suite, write_suite
from probe.tasks.task import Letter, Task
from probe.toolshed.result import Answer
from probe.types import Pose

CHECKS, SIGNED = "forgeries", "forgeries of a signed folder"

Forge = Callable[[EpisodeRecord, Task], EpisodeRecord]


def _other(task: Task) -> Letter:
    return "A" if task.answer != "A" else "B"


def _with_steps(record: EpisodeRecord, steps: tuple[Step, ...]) -> EpisodeRecord:
    times = (1.0,) * len(steps)
    return replace(record, steps=steps, seconds=Seconds(times, times))


def _moved(scene: Scene, instance: int) -> Scene:
    away = Pose((0.21, -0.2, 0.03))
    return replace(scene, objects=tuple(
        replace(it, pose=away) if it.instance == instance else it for it in scene.objects
    ))  # fmt: skip


def _target_moved(record: EpisodeRecord, task: Task) -> EpisodeRecord:
    """From the first grasp on the target lies where nothing put it."""
    first = next(n for n, it in enumerate(record.steps) if it.call.name == "grasp_and_remove")
    steps = tuple(
        replace(it, after=TableState(_moved(it.after.scene, task.targets[0]), it.after.joints))
        if number >= first
        else it
        for number, it in enumerate(record.steps)
    )
    return replace(record, steps=steps)


def _without_a_thing(record: EpisodeRecord, task: Task) -> EpisodeRecord:
    gone = task.targets[0]

    def bare(table: TableState) -> TableState:
        return TableState(table.scene.without(gone), table.joints)

    steps = tuple(replace(step, after=bare(step.after)) for step in record.steps)
    return replace(record, start=bare(record.start), steps=steps)


def _long(record: EpisodeRecord, _: Task) -> EpisodeRecord:
    look = replace(record.steps[0], after=record.start)
    return _with_steps(record, (look,) * 145 + record.steps)


def _told(record: EpisodeRecord, task: Task) -> EpisodeRecord:
    first = replace(record.steps[0], text=f"{record.steps[0].text}\nThe answer is {task.answer}.")
    return replace(record, steps=(first, *record.steps[1:]))


def _called_otherwise(record: EpisodeRecord, _: Task) -> EpisodeRecord:
    look = Call.of("find_object", {"description": "the thing at (500, 500)"})
    return replace(record, steps=(replace(record.steps[0], call=look), *record.steps[1:]))


def _without_moves(record: EpisodeRecord, _: Task) -> EpisodeRecord:
    steps = tuple(it for it in record.steps if it.call.name not in ("grasp_and_remove", "push"))
    return _with_steps(record, steps)


FORGERIES: dict[str, Forge] = {
    "another answer than the last call's": lambda it, task: replace(
        it, answer=Answer(_other(task))
    ),
    "an invented point": lambda it, task: replace(it, answer=Answer(task.answer, (500.0, 500.0))),
    "all steps deleted": lambda it, _: _with_steps(it, ()),
    "its moves deleted": _without_moves,
    "the target moved under an invented point": _target_moved,
    "145 more steps": _long,
    "an ended episode with an answer": lambda it, _: replace(it, end="out_of_turns"),
    "a fault with an answer": lambda it, _: replace(it, end="fault", fault="OSError: the power"),
    "objects taken out of its scenes": _without_a_thing,
    "another noise": lambda it, _: replace(it, noise=Noise(0.0, 0.0)),
    "another run's luck": lambda it, _: replace(it, run=1),
    "other words of a tool": _told,
    "another call": _called_otherwise,
    "another question": lambda it, _: replace(it, question=replace(it.question, text="What?")),
    "a step's status": lambda it, _: replace(
        it, steps=(replace(it.steps[0], status="refused"), *it.steps[1:])
    ),
}  # fmt: skip

VOUCHED: dict[str, Forge] = {
    "another agent's name": lambda it, _: replace(it, agent="somebody-else"),
    "other times": lambda it, _: _with_steps(it, it.steps),
}
"""What no file can prove of itself: docs/how-to/audit.md says so."""


def attack_records(folder: Path, run: Path, scale: float) -> Iterator[Attack]:
    """Forge an episode that was played, with right checksums; an honest one must pass.

    Args:
        folder: To work in.
        run: A folder with one episode of the demo in which a hand that errs lifts something; it is
            copied.
        scale: The share of forgeries that is tried.
    """
    run = shutil.copytree(run, folder / "played")
    honest = probe("audit", run, "--replay", "all")
    verdict = "harmless" if honest.returncode == 0 else "crashed"
    yield Attack(CHECKS, "an honest one", verdict, honest.stderr[-300:])
    for name, forge in some(list(FORGERIES.items()), scale):
        forged = _forged(folder, run, forge)
        yield refusal(CHECKS, name, "audit", forged, "--replay", "all")
    yield _renamed(folder, run)
    yield from _signed(folder, run)


def _forged(folder: Path, run: Path, forge: Forge) -> Path:
    copy = folder / "forged"
    shutil.rmtree(copy, ignore_errors=True)
    shutil.copytree(run, copy, ignore=shutil.ignore_patterns(AUDIT, "pictures"))
    tasks = {task.id: task for task in read_suite(copy / SUITE).tasks}
    records = [forge(record, tasks[record.task]) for record in read_records(copy / RECORDS)]
    write_records(copy / RECORDS, records)
    return copy


def _renamed(folder: Path, run: Path) -> Attack:
    """Other answers in a suite that bears a packaged name; its hashes fit."""
    copy = _forged(folder, run, lambda it, _: it)
    suite = read_suite(copy / SUITE)
    tasks = tuple(replace(task, answer=_other(task)) for task in suite.tasks)
    write_suite(copy / SUITE, Suite(suite.name, tasks, suite.objects))
    return refusal(CHECKS, "other answers under a packaged name", "rescore", copy)


def _signed(folder: Path, run: Path) -> Iterator[Attack]:
    key = folder / "key"
    subprocess.run(["ssh-keygen", "-q", "-t", "ed25519", "-N", "", "-f", str(key)], check=True)
    probe("audit", run, "--sign", key)
    keys = key.with_suffix(".pub")
    whole = probe("audit", run, "--verify", keys)
    verdict = "harmless" if whole.returncode == 0 else "crashed"
    yield Attack(SIGNED, "nothing changed", verdict, whole.stderr[-300:])
    for name, forge in VOUCHED.items():
        yield refusal(SIGNED, name, "audit", _forged(folder, run, forge), "--verify", keys)
    copy = _forged(folder, run, lambda it, _: it)
    content = json.loads((copy / "ordered.json").read_text())
    (copy / "ordered.json").write_text(json.dumps(content))
    yield refusal(SIGNED, "a file written anew", "audit", copy, "--verify", keys)
