"""Many trials, scene by scene, into a file that is whole at any moment and can be gone on with."""

from __future__ import annotations

import itertools
from base64 import b64decode
from collections import deque
from collections.abc import Iterator
from contextlib import closing
from pathlib import Path

from pydantic import ValidationError

from probe.engines.plan import Engine, LostUnit, WorkPlan
from probe.errors import BadData, WorkerDied
from probe.files import claim_folder, fault, write_bytes
from probe.reading import RECORDS, contents
from probe.tool_bench.scene_trials import (
    SceneTrials,
    ToolBenchSettings,
    TrialMaker,
    TrialScene,
    picture_path,
)
from probe.tool_bench.table import A_SCENE
from probe.tool_bench.trial import Tool, ToolTrial
from probe.types import Shard

SETTINGS = "settings.json"


def start(out: Path, settings: ToolBenchSettings) -> None:
    """Make the folder, or see that it is about the same settings.

    Raises:
        BadData: It is about others.
        OutputFailed: It can't be written.
    """
    claim_folder(out / SETTINGS, settings, "Choose another folder.")


def read_trials(out: Path) -> list[ToolTrial]:
    """All trials of a folder, by tool, seed and order.

    Raises:
        BadData: A line is no trial.
    """
    files = sorted(out.glob("trials-*.jsonl"))
    found = [trial for file in files for trial in _read(file)]
    return sorted(found, key=lambda trial: (trial.tool, trial.seed))


def carry_out(
    out: Path, tool: Tool, wanted: int, maker: TrialMaker, engine: Engine, shard: Shard
) -> Iterator[int]:
    """Do what is missing of so many trials; yields after each scene how many there are.

    Scenes count in the order of their seeds, whichever is done first, so that the trials are the
    same with any engine.

    Raises:
        BadData: What is there can't be read.
        OutputFailed: The disk is full; what was there is still whole.
        WorkerDied: Workers die over a scene.
    """
    path = out / f"trials-{shard.number}-of-{shard.count}.jsonl"
    done = _read(path) if path.exists() else []
    seeds = {trial.seed for trial in done if trial.tool == tool}
    count = sum(trial.tool == tool for trial in done)
    free = (
        seed
        for seed in itertools.count(maker.settings.first_seed + shard.number, shard.count)
        if seed not in seeds
    )
    while count < wanted:
        needed = -(-(wanted - count) // A_SCENE)
        scenes = [TrialScene(tool, seed) for seed in itertools.islice(free, needed)]
        for found in _in_order(maker.plan(scenes), engine):
            fresh = found.trials[: wanted - count]
            for trial in fresh:
                if picture := found.pictures.get(picture_path(trial)):
                    write_bytes(out / picture_path(trial), b64decode(picture))
            done += fresh
            write_bytes(path, b"".join(t.model_dump_json().encode() + b"\n" for t in done))
            count += len(fresh)
            yield count


def _in_order(plan: WorkPlan[TrialScene], engine: Engine) -> Iterator[SceneTrials]:
    """Results in the order of the plan, each as soon as it and all before it are there."""
    early, waiting = dict[TrialScene, bytes](), deque(plan.units)
    with closing(engine.carry_out(plan)) as results:
        for scene, result in results:
            if isinstance(result, LostUnit):
                raise WorkerDied(f"trying the {scene.tool} on seed {scene.seed}")
            early[scene] = result
            while waiting and waiting[0] in early:
                yield SceneTrials.model_validate_json(early.pop(waiting.popleft()))


def _read(path: Path) -> list[ToolTrial]:
    trials: list[ToolTrial] = []
    try:
        lines = contents(path, RECORDS).splitlines()
    except OSError as error:
        raise BadData(path, error.strerror or str(error), "Check the path") from error
    for number, line in enumerate(lines, start=1):
        try:
            trials.append(ToolTrial.model_validate_json(line))
        except ValidationError as error:
            remedy = "Delete this line; its scene is tried again."
            raise BadData(f"{path}:{number}", fault(error, "the line"), remedy) from error
    return trials
