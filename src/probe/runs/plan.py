"""Which episodes a run consists of, and which of them one machine does. Data only."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass

from probe.episodes.conditions import AS_FROZEN, Conditions
from probe.episodes.noise import NO_NOISE, Noise
from probe.episodes.participation import Points
from probe.episodes.perceptions import ORACLE_USED, PerceptionUsed
from probe.tasks.task import Task
from probe.types import Shard


@dataclass(frozen=True)
class Job:
    """One episode to be run.

    Attributes:
        task: What is asked.
        run: Which of the agent's runs at it this is.
    """

    task: Task
    run: int


@dataclass(frozen=True)
class RunOrder:
    """What is to be run.

    Attributes:
        agent: Name of who acts.
        runs: Episodes of each task.
        noise: How far the hand errs.
        conditions: In what episodes differ from their tasks.
        shard: Which part of them.
        setting: How a model is allowed to answer; empty for other agents.
        points: How a model counts places in pictures.
        perception: What the tools see with.
    """

    agent: str
    runs: int = 1
    noise: Noise = NO_NOISE
    conditions: Conditions = AS_FROZEN
    shard: Shard = Shard()
    setting: str = ""
    points: Points = "pixels"
    perception: PerceptionUsed = ORACLE_USED

    def jobs(
        self, tasks: Sequence[Task], done: Collection[tuple[str, str, str, int]] = ()
    ) -> list[Job]:
        """What is left to do, in order of task and run.

        Args:
            tasks: Of the suite.
            done: Task, agent, setting and run of episodes that needn't be run again.
        """
        mine = self.shard.of([Job(task, run) for task in tasks for run in range(self.runs)])
        return [job for job in mine if (job.task.id, self.agent, self.setting, job.run) not in done]
