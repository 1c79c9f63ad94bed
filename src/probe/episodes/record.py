"""All that happened in one episode: enough to draw, grade and replay it without physics."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import Literal

from probe.assets.pools.division import Shown, shown_of
from probe.episodes.circumstances import Circumstances
from probe.episodes.conditions import AS_FROZEN, Conditions
from probe.episodes.noise import NO_NOISE, Noise
from probe.episodes.participation import Participation
from probe.episodes.perceptions import ORACLE_USED, PerceptionUsed
from probe.episodes.turns import Call, Question
from probe.scene.scene import Scene
from probe.scene.setup import picture_scale
from probe.scene.viewpoint import Viewpoint
from probe.toolshed.result import MOVING, Answer, Status
from probe.toolshed.version import TOOLS_VERSION
from probe.types import PictureScale

End = Literal["answered", "stopped", "out_of_turns", "fault"]


@dataclass(frozen=True)
class TableState:
    """How things stand: every object's pose, and the arm's joints in radians."""

    scene: Scene
    joints: tuple[float, ...]


@dataclass(frozen=True)
class Step:
    """One call, what the agent read, and the table afterwards.

    Attributes:
        call: What the agent sent.
        status: How it went, for statistics.
        text: What the agent read.
        point_px: (u, v) of what the call was about, if it was about one thing.
        after: The table when it was over.
    """

    call: Call
    status: Status
    text: str
    point_px: tuple[int, int] | None
    after: TableState


@dataclass(frozen=True)
class Seconds:
    """Wall time of each step: the agent's and the tools'. Never the same twice."""

    agent: tuple[float, ...] = ()
    tools: tuple[float, ...] = ()


@dataclass(frozen=True)
class EpisodeRecord:
    """One episode.

    Attributes:
        task: Which task; the caller's name for it.
        agent: Which agent; the caller's name for it.
        run: Number of the run, if an agent tries a task several times.
        question: What was asked.
        start: The table at the start.
        steps: One for each call.
        answer: The final answer, if one was given.
        end: Why it ended; "stopped" is the agent's own choice, "fault" is no fault of the
            agent.
        fault: What failed, for the end "fault".
        seconds: Timing, which no comparison takes into account.
        noise: How far the hand erred; with the task's seed and the run it gives the same luck.
        conditions: In what the run differed from its tasks.
        viewpoint: Where the camera stood, and the light.
        participation: How a model took part, or how an agent's own process failed; else None.
        tools: Version of the tools.
        perception: What the tools saw with.
        frames: Of a real table the pictures at the start and after each step, by their names in
            the run's folder (see film.py); its scenes hold the set-up alone. Empty in simulation.
    """

    task: str
    agent: str
    run: int
    question: Question
    start: TableState
    steps: tuple[Step, ...]
    answer: Answer | None
    end: End
    fault: str | None = None
    seconds: Seconds = Seconds()
    noise: Noise = NO_NOISE
    conditions: Conditions = AS_FROZEN
    viewpoint: Viewpoint = field(default_factory=Viewpoint)
    participation: Participation | None = None
    tools: int = TOOLS_VERSION
    perception: PerceptionUsed = ORACLE_USED
    frames: tuple[str, ...] = ()

    @property
    def label(self) -> str:
        """In what it differs from its task and from the usual perception, in a few words."""
        return ", ".join(filter(None, (self.conditions.label, self.perception.label)))

    @property
    def setting(self) -> str:
        """How a model was allowed to answer; empty for other agents, whose names say it."""
        return self.participation.setting if self.participation else ""

    @property
    def pool(self) -> Shown | None:
        """For what the built-in objects on its table are; None if there are none."""
        return shown_of(placed.object_id for placed in self.start.scene.objects)

    @property
    def scenes(self) -> tuple[Scene, ...]:
        """The table at the start and after each step."""
        return (self.start.scene, *(step.after.scene for step in self.steps))

    @property
    def circumstances(self) -> Circumstances:
        """Under which it came about."""
        return Circumstances(self.run, self.noise, self.conditions, self.viewpoint, self.perception)

    def under(self, circumstances: Circumstances) -> EpisodeRecord:
        """The record with what it says of its circumstances, the number of its run apart."""
        return replace(
            self,
            noise=circumstances.noise,
            conditions=circumstances.conditions,
            viewpoint=circumstances.viewpoint or self.viewpoint,
            perception=circumstances.perception,
        )

    @property
    def scale(self) -> PictureScale:
        """What its pictures show."""
        return picture_scale(self.start.scene.setup, self.viewpoint.camera)

    @property
    def manipulations(self) -> int:
        """Grasps and pushes that were carried out, failed ones included."""
        moving = [s for s in self.steps if s.call.name in MOVING]
        return sum(step.status in ("done", "failed") for step in moving)

    def untimed(self) -> EpisodeRecord:
        """The record without what is never the same twice."""
        return replace(self, seconds=Seconds())
