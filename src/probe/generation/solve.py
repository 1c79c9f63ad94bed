"""The solvable check: two unlike scripted agents with the same tools, three attempts each."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import get_args

from probe.agents.moves import Way
from probe.agents.scripted import Scripted
from probe.assets.library import Library
from probe.episodes.circumstances import Circumstances
from probe.episodes.noise import NOISES
from probe.episodes.play import play, score
from probe.render.renderer import Renderer
from probe.scene.lighting import AMBIENT
from probe.scene.seeds import generator
from probe.scene.viewpoint import Viewpoint
from probe.tasks.task import TRIAL_RULES, Task

ATTEMPTS = 3
"""Attempts of each agent."""

MOST_MANIPULATIONS = 45
"""After so many on one candidate no further attempt begins. Deeds are counted, not seconds: what is
kept mustn't depend on the machine or on what else it does (decision 25)."""

WAYS: tuple[Way, ...] = get_args(Way)

_ATTEMPT, _BY_PUSHING = "solved_attempt", "solved_by_pushing_first"

FIRST_RUN = 1_000_000
"""Number of the first attempt's run: no benchmark's run has its luck."""


@dataclass(frozen=True)
class SolveAttempt:
    """One attempt of one scripted agent.

    Attributes:
        way: What the agent tries first.
        attempt: From 0.
        solved: Whether its answer was right; agents stop without one where they lack evidence.
        manipulations: How often it grasped and pushed.
    """

    way: Way
    attempt: int
    solved: bool
    manipulations: int = 0


def trials(task: Task, library: Library, renderer: Renderer) -> tuple[SolveAttempt, ...]:
    """Attempts until one solves the task, all have been made, or MOST_MANIPULATIONS have.

    The hand errs.

    The very first attempt is always made: its share of successes over all candidates is what
    scripted agents achieve on tasks that were not selected by them.
    """
    return enough(
        _try(task, way, attempt, library, renderer) for attempt in range(ATTEMPTS) for way in WAYS
    )


def enough(attempts: Iterable[SolveAttempt]) -> tuple[SolveAttempt, ...]:
    """Attempts up to the first that succeeds, or that brings them to MOST_MANIPULATIONS."""
    made: list[SolveAttempt] = []
    for trial in attempts:
        made.append(trial)
        if trial.solved or sum(each.manipulations for each in made) >= MOST_MANIPULATIONS:
            break
    return tuple(made)


def _try(
    task: Task,
    way: Way,
    attempt: int,
    library: Library,
    renderer: Renderer,
) -> SolveAttempt:
    rng = generator(task.seed, "solve", way, attempt)
    agent = Scripted(task.question_type, task.subject, rng, way, form=task.form)
    circumstances = Circumstances(FIRST_RUN + attempt, NOISES["paper"], viewpoint=_seen(task))
    record = play(task, agent, f"scripted-{way}", library, renderer, circumstances)
    solved = score(task, record, renderer).correct
    return SolveAttempt(way, attempt, solved, record.manipulations)


def _seen(task: Task) -> Viewpoint | None:
    """How attempts see the table: as it was made, or in even light.

    A picture of a room with shadows takes four times as long. What is checked is whether hand and
    plan bring out the answer, and of pictures they use colours alone, to know a thing again.
    """
    return None if task.version < TRIAL_RULES else replace(task.viewpoint, lighting=AMBIENT)


def is_noted_as_solved(task: Task) -> bool:
    """Whether a task's certificate notes an attempt that solved it."""
    return _ATTEMPT in task.certificate.measures


def solves_as_noted(task: Task, library: Library, renderer: Renderer) -> bool:
    """Whether the attempt that the certificate notes solves the task again.

    On another kind of machine it may not, and another attempt may.
    """
    if not is_noted_as_solved(task):
        return False
    notes = task.certificate.measures
    way: Way = "push" if notes[_BY_PUSHING] else "grasp"
    return _try(task, way, int(notes[_ATTEMPT]), library, renderer).solved


def noted(task: Task, made: tuple[SolveAttempt, ...]) -> Task:
    """A task whose certificate says which attempt solved it; as it is without one."""
    last = next((trial for trial in made if trial.solved), None)
    if last is None:
        return task
    notes = {
        _ATTEMPT: float(last.attempt),
        _BY_PUSHING: float(last.way == "push"),
    }
    proof = task.certificate
    return replace(task, certificate=replace(proof, measures={**proof.measures, **notes}))
