"""Many trials, scene by scene, into a file that is whole at any moment and can be gone on with."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Literal

import numpy as np
from PIL import Image
from pydantic import BaseModel, ConfigDict, ValidationError
from scipy import ndimage

from probe.assets.library import Library, Pool
from probe.episodes.noise import Noise
from probe.errors import BadData, Unsatisfiable
from probe.files import claim_folder, encode, fault, write_bytes
from probe.manipulation.candidates import Planner, propose
from probe.manipulation.graspgen import GraspGen
from probe.reading import RECORDS, contents
from probe.render.renderer import Renderer
from probe.scene.scene import PlacedObject
from probe.tool_bench.attempt import attempt
from probe.tool_bench.table import TrialTable, lay
from probe.tool_bench.trial import Tool, ToolTrial
from probe.types import Array, Shard

SETTINGS, PICTURES = "settings.json", "pictures"
_SIDE_PX = 512
_LINE_PX = 5
_OUTLINE = np.array([255, 40, 200], np.uint8)


class ToolBenchSettings(BaseModel):
    """What trials of one folder have in common."""

    model_config = ConfigDict(frozen=True, extra="forbid")

    version: Literal[1] = 1
    pool: Pool
    grasp_noise: float
    push_noise: float
    first_seed: int
    graspgen: str | None = None
    """Address of a GraspGen server; None for the built-in planner."""

    @property
    def planner(self) -> Planner:
        """What proposes the grasps."""
        return GraspGen(self.graspgen) if self.graspgen else propose

    @property
    def noise(self) -> Noise:
        """By how much the hand errs."""
        return Noise(self.grasp_noise, self.push_noise)


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
    out: Path,
    tool: Tool,
    wanted: int,
    settings: ToolBenchSettings,
    things: Library,
    renderer: Renderer,
    shard: Shard,
) -> Iterator[int]:
    """Do what is missing of so many trials; yields after each scene how many there are.

    Raises:
        BadData: What is there can't be read.
        OutputFailed: The disk is full; what was there is still whole.
    """
    path = out / f"trials-{shard.number}-of-{shard.count}.jsonl"
    done = _read(path) if path.exists() else []
    seeds = {trial.seed for trial in done if trial.tool == tool}
    count = sum(trial.tool == tool for trial in done)
    seed = settings.first_seed + shard.number
    while count < wanted:
        if seed not in seeds:
            fresh = _scene(out, tool, seed, wanted - count, settings, things, renderer)
            done += fresh
            write_bytes(path, b"".join(t.model_dump_json().encode() + b"\n" for t in done))
            count += len(fresh)
            yield count
        seed += shard.count


def picture_path(trial: ToolTrial) -> str:
    """Where the pictures of a failure lie, in the folder."""
    return f"{PICTURES}/{trial.tool}-{trial.seed}-{trial.instance}.jpg"


def _scene(
    out: Path,
    tool: Tool,
    seed: int,
    at_most: int,
    settings: ToolBenchSettings,
    things: Library,
    renderer: Renderer,
) -> list[ToolTrial]:
    try:
        laid = lay(seed, tool, things, renderer)
    except Unsatisfiable:
        return []
    made: list[ToolTrial] = []
    for target in laid.targets[:at_most]:
        trial = attempt(tool, laid, target, things, renderer, settings.noise, settings.planner)
        made.append(trial)
        if not trial.good:
            _photograph(out / picture_path(trial), laid, target, renderer)
    return made


def _photograph(path: Path, laid: TrialTable, target: PlacedObject, renderer: Renderer) -> None:
    """The table before, with the target outlined, beside the table as it is now."""
    camera = laid.frame.camera
    before = renderer.draw(laid.scene.objects, camera, rgb=True).rgb
    after = renderer.draw(laid.world.scene().objects, camera, rgb=True).rgb
    assert before is not None and after is not None
    pair = np.concatenate([_outlined(before, laid.mask(target)), after], axis=1)
    small = Image.fromarray(pair).resize((2 * _SIDE_PX, _SIDE_PX), Image.Resampling.BOX)
    write_bytes(path, encode(small, "JPEG"))


def _outlined(picture: Array, mask: Array) -> Array:
    around: Array = ndimage.binary_dilation(mask, iterations=_LINE_PX) & ~mask
    return np.where(around[..., None], _OUTLINE, picture)


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
