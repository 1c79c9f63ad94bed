"""The trials of one scene, as a unit of work for any engine."""

from __future__ import annotations

import hashlib
from base64 import b64encode
from collections.abc import Callable, Generator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Literal, NamedTuple

import numpy as np
from PIL import Image
from pydantic import BaseModel, ConfigDict
from scipy import ndimage

from probe.assets.library import Library, Pool
from probe.engines.plan import WorkPlan
from probe.episodes.noise import Noise
from probe.errors import Unsatisfiable
from probe.files import encode
from probe.manipulation.candidates import Planner
from probe.manipulation.grasp import PLANNERS
from probe.manipulation.graspgen import GraspGen
from probe.render.renderer import Renderer
from probe.scene.scene import PlacedObject
from probe.tool_bench.attempt import attempt
from probe.tool_bench.table import TrialTable, lay
from probe.tool_bench.trial import Tool, ToolTrial
from probe.types import Array

PICTURES = "pictures"
_SIDE_PX = 512
_LINE_PX = 5
_OUTLINE = np.array([255, 40, 200], np.uint8)


class TrialScene(NamedTuple):
    """A unit of work: a tool, on the targets of a seed's scene."""

    tool: Tool
    seed: int


class ToolBenchSettings(BaseModel):
    """What trials of one folder have in common.

    Attributes:
        tools: Version of the tools; 1 in files of before it was written down.
    """

    model_config = ConfigDict(frozen=True, extra="forbid")

    version: Literal[1] = 1
    pool: Pool
    grasp_noise: float
    push_noise: float
    first_seed: int
    graspgen: str | None = None
    """Address of a GraspGen server; None for the built-in planners."""
    tools: int = 1

    @property
    def planners(self) -> Sequence[Planner]:
        """What proposes the grasps."""
        return (GraspGen(self.graspgen),) if self.graspgen else PLANNERS

    @property
    def noise(self) -> Noise:
        """By how much the hand errs."""
        return Noise(self.grasp_noise, self.push_noise)


@dataclass(frozen=True)
class TrialMaker:
    """What tries a tool on a scene's targets; see probe.processes.serving.Opening.

    Attributes:
        settings: Of all trials.
        library: Opens the objects.
    """

    settings: ToolBenchSettings
    library: Callable[[], Library]

    @contextmanager
    def __call__(self) -> Generator[Callable[[TrialScene], bytes]]:
        """Open the library and start a renderer; gives what does a scene's trials."""
        things = self.library()
        with Renderer(things.light_cache) as renderer:
            yield lambda scene: self._tried(scene, things, renderer).model_dump_json().encode()

    def plan(self, scenes: Sequence[TrialScene]) -> WorkPlan[TrialScene]:
        """The work of some scenes."""
        how = hashlib.sha256(self.settings.model_dump_json().encode()).hexdigest()[:32]
        return WorkPlan(f"trials-{how}", self, scenes, lambda scene: "-".join(map(str, scene)))

    def _tried(self, scene: TrialScene, things: Library, renderer: Renderer) -> SceneTrials:
        try:
            laid = lay(scene.seed, scene.tool, things, renderer)
        except Unsatisfiable:
            return SceneTrials()
        made, pictures = list[ToolTrial](), dict[str, str]()
        settings = self.settings
        for target in laid.targets:
            trial = attempt(
                scene.tool, laid, target, things, renderer, settings.noise, settings.planners
            )
            made.append(trial)
            if not trial.good:
                picture = _photograph(laid, target, renderer)
                pictures[picture_path(trial)] = b64encode(picture).decode()
        return SceneTrials(trials=tuple(made), pictures=pictures)


class SceneTrials(BaseModel):
    """A scene's trials, and pictures of those that failed, by path, in base 64."""

    model_config = ConfigDict(frozen=True, extra="forbid")

    trials: tuple[ToolTrial, ...] = ()
    pictures: Mapping[str, str] = {}


def picture_path(trial: ToolTrial) -> str:
    """Where the pictures of a failure lie, in the folder."""
    return f"{PICTURES}/{trial.tool}-{trial.seed}-{trial.instance}.jpg"


def _photograph(laid: TrialTable, target: PlacedObject, renderer: Renderer) -> bytes:
    """The table before, with the target outlined, beside the table as it is now; a JPEG file."""
    camera = laid.frame.camera
    before = renderer.draw(laid.scene.objects, camera, rgb=True).rgb
    after = renderer.draw(laid.world.scene().objects, camera, rgb=True).rgb
    assert before is not None and after is not None
    pair = np.concatenate([_outlined(before, laid.mask(target)), after], axis=1)
    small = Image.fromarray(pair).resize((2 * _SIDE_PX, _SIDE_PX), Image.Resampling.BOX)
    return encode(small, "JPEG")


def _outlined(picture: Array, mask: Array) -> Array:
    around: Array = ndimage.binary_dilation(mask, iterations=_LINE_PX) & ~mask
    return np.where(around[..., None], _OUTLINE, picture)
