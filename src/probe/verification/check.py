"""All checks of one frozen task."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from probe.assets.library import Library
from probe.generation.attempt import Attempt
from probe.generation.build import without_notes
from probe.generation.first_look import look_at
from probe.generation.generate import make
from probe.generation.look_alikes import look_alike
from probe.generation.observer import observe
from probe.generation.result import TaskCandidate
from probe.generation.solve import is_noted_as_solved, solves_as_noted, trials
from probe.render.renderer import Renderer
from probe.tasks.suite_file import digest_of
from probe.tasks.task import STEP_RULES, Task
from probe.verification.completeness import makeup_problems
from probe.verification.hidden import hidden_problems
from probe.verification.histories import histories, history_problems, is_reachable
from probe.verification.remeasure import Remeasurement
from probe.verification.text import text_problems
from probe.verification.truth import clarity_problems, truth_problems
from probe.verification.verdict import TaskVerdict


@dataclass(frozen=True)
class CheckDepth:
    """Which of the checks that take long are made.

    Attributes:
        solve: Whether a scripted agent solves it again.
        history: Whether random histories are played.
    """

    solve: bool = True
    history: bool = False


def check(task: Task, library: Library, renderer: Renderer, depth: CheckDepth) -> TaskVerdict:
    """Make the checks on one task; what was loaded in the renderer is replaced.

    Where a task lacks something that its type has, only its text is checked.
    """
    if broken := tuple(makeup_problems(task, library)):
        return TaskVerdict(
            task=task.id,
            question_type=task.question_type,
            digest=digest_of(task),
            problems={"text": broken},
        )
    anew = Remeasurement(task.scene, library, renderer, task.camera)
    problems = _measured(task, library, anew)
    if alike := look_alike(task, library, renderer):
        problems["unambiguous"] += (alike,)
    untrue = list(problems.pop("invariant"))
    problems["at rest"] = tuple(filter(None, [anew.restaged.unrest()]))
    played = reachable = 0
    if depth.history:
        for record in histories(task, library, renderer):
            untrue += history_problems(task, record, renderer)
            played += 1
            reachable += is_reachable(task, record.scenes[-1])
    problems["invariant"] = tuple(untrue)
    unsolved = tuple(_unsolved(task, library, renderer)) if depth.solve else ()
    outgrown = bool(unsolved) and task.version < STEP_RULES and is_noted_as_solved(task)
    if depth.solve:
        problems["solvable"] = () if outgrown else unsolved
    return TaskVerdict(
        task=task.id,
        question_type=task.question_type,
        digest=digest_of(task),
        problems=problems,
        solved=depth.solve,
        outgrown=outgrown,
        histories=played,
        reachable=reachable,
        observed=None if any(problems.values()) else _observed(task, library, renderer),
    )


def what_is_wrong(task: Task, library: Library, renderer: Renderer) -> dict[str, tuple[str, ...]]:
    """What measuring a task that was just made finds wrong, by check; empty if nothing.

    What a generator measured can come out otherwise once things have settled again. Whether it is
    at rest, and looks like another, is left to the build, which asks that of every candidate.
    """
    if broken := tuple(makeup_problems(task, library)):
        return {"text": broken}
    problems = _measured(task, library, Remeasurement(task.scene, library, renderer, task.camera))
    return {name: found for name, found in problems.items() if found}


def _measured(task: Task, library: Library, anew: Remeasurement) -> dict[str, tuple[str, ...]]:
    """What reading a task and measuring its scene finds wrong, by check."""
    return {
        "text": tuple(text_problems(task, library)),
        "hidden": tuple(hidden_problems(task, anew)),
        "unambiguous": tuple(clarity_problems(task, anew)),
        "invariant": tuple(truth_problems(task, anew)),
    }


def _unsolved(task: Task, library: Library, renderer: Renderer) -> Iterator[str]:
    if solves_as_noted(task, library, renderer):
        return
    made = trials(task, library, renderer)
    if not any(trial.solved for trial in made):
        yield f"none of {len(made)} attempts"


def _observed(task: Task, library: Library, renderer: Renderer) -> bool:
    """Whether somebody who only looks, and follows a rule, is right."""
    options = [option.text for option in task.options]
    look = look_at(task, library, renderer)
    return observe(task.question_type, task.form, task.question, options, look) == task.answer


def rebuild_problem(
    task: Task,
    library: Library,
    renderer: Renderer,
    tables: Sequence[str],
    attempt: Attempt | None = None,
) -> str | None:
    """What is different if a task is made again; None if nothing is. See rebuilt()."""
    made = rebuilt(task, library, renderer, tables, attempt)
    return made if isinstance(made, str) else None


def rebuilt(
    task: Task,
    library: Library,
    renderer: Renderer,
    tables: Sequence[str],
    attempt: Attempt | None = None,
) -> TaskCandidate | str:
    """A task made again, or what is different then.

    Args:
        task: The task.
        library: Objects that it was made of.
        renderer: What was loaded in it is replaced.
        tables: Ids of table materials that it was made with.
        attempt: That made it; where it isn't given, its seed tells.
    """
    attempt = attempt or Attempt.of_task(task)
    result = make(attempt, library, renderer, tables)
    if not isinstance(result, TaskCandidate):
        return f"its seed now fails {result.check}: {result.detail}"
    frozen, made = digest_of(without_notes(task)), digest_of(result.task)
    return result if frozen == made else f"its hash is {made}, not {frozen}"
