"""The solvable check: two unlike scripted agents with the same tools, three attempts each."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import get_args

from probe.agents.moves import Way
from probe.agents.scripted import Scripted
from probe.assets.library import Library
from probe.assets.tables import TableMaterial
from probe.episodes.luck import NOISES
from probe.episodes.play import play, score
from probe.render.renderer import Renderer
from probe.scene.seeds import generator
from probe.tasks.task import Task

ATTEMPTS = 3
"""Attempts of each agent."""

WAYS: tuple[Way, ...] = get_args(Way)

FIRST_RUN = 1_000_000
"""Number of the first attempt's run: no benchmark's run has its luck."""


@dataclass(frozen=True)
class Trial:
    """One attempt of one scripted agent.

    Attributes:
        way: What the agent tries first.
        attempt: From 0.
        solved: Whether its answer was right; agents stop without one where they lack evidence.
    """

    way: Way
    attempt: int
    solved: bool


def trials(
    task: Task, library: Library, table: TableMaterial, renderer: Renderer
) -> tuple[Trial, ...]:
    """Attempts until one solves the task or all have been made, with a hand that errs.

    The very first attempt is always made: its share of successes over all candidates is what
    scripted agents achieve on tasks that were not selected by them.
    """
    made: list[Trial] = []
    for attempt in range(ATTEMPTS):
        for way in WAYS:
            agent = Scripted(
                task.kind,
                task.subject,
                generator(task.seed, "solve", way, attempt),
                way,
                form=task.form,
            )
            record = play(
                task,
                agent,
                f"scripted-{way}",
                library,
                table,
                renderer,
                FIRST_RUN + attempt,
                NOISES["paper"],
            )
            made.append(Trial(way, attempt, score(task, record, renderer).correct))
            if made[-1].solved:
                return tuple(made)
    return tuple(made)


def noted(task: Task, made: tuple[Trial, ...]) -> Task:
    """A task whose certificate says which attempt solved it; as it is without one."""
    last = next((trial for trial in made if trial.solved), None)
    if last is None:
        return task
    notes = {
        "solved_attempt": float(last.attempt),
        "solved_by_pushing_first": float(last.way == "push"),
    }
    proof = task.certificate
    return replace(task, certificate=replace(proof, measures={**proof.measures, **notes}))
