"""Builds a suite: candidates, their checks, the solvable check; place by place, resumable."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from time import monotonic

from probe.assets.library import Library, Pool
from probe.episodes.tool_errors import HEADLINE
from probe.errors import BadData, Unsatisfiable
from probe.generation.attempt import Attempt
from probe.generation.build_folder import (
    IMMOVABLE,
    KEPT,
    LOOK_ALIKE,
    REPEATED,
    RESTLESS,
    UNSOLVED,
    UNVERIFIED,
    BuildFolder,
    BuildSettings,
    CandidateLog,
    TaskSlot,
)
from probe.generation.generate import make
from probe.generation.look_alikes import look_alike
from probe.generation.movable import immovable
from probe.generation.plan import ATTEMPTS
from probe.generation.restored_stage import RestoredStage
from probe.generation.result import Rejection, TaskCandidate
from probe.generation.salt import Salt
from probe.generation.salt_file import salt_of
from probe.generation.solve import SolveAttempt, noted, trials
from probe.generation.task_generator import generator_of
from probe.render.renderer import Renderer
from probe.scene.setup import UR5_TABLE, Setup
from probe.scene.setup_file import SetupDocument
from probe.tasks.suite import freeze
from probe.tasks.suite_file import read_suite, write_suite
from probe.tasks.task import (
    ERROR_RULES,
    NEWEST_RULES,
    QUESTION_TYPES,
    QuestionType,
    RulesVersion,
    Task,
)

Audit = Callable[[Task, Library, Renderer], Mapping[str, Sequence[str]]]
"""Measures a finished task once more, as a stranger would: what is wrong, by check."""

_REASONS = 3

_MANY: tuple[Pool, ...] = "procedural", "procedural-2", "train", "evaluation"
"""Pools large enough for the newest rules."""


@dataclass(frozen=True)
class BuildResources:
    """What tasks are made with.

    Attributes:
        salt: Of a private suite.
        setup: The table that tasks are for.
        rules: The version of the rules that they are made by.
        audit: Measures tasks once more; then skills and scripted agents are tried on them. None
            leaves out all three: for tests of the generator, and for training.
    """

    library: Library
    tables: Sequence[str]
    renderer: Renderer
    audit: Audit | None = None
    salt: Salt | None = None
    setup: Setup = UR5_TABLE
    rules: RulesVersion = NEWEST_RULES


def rules_for(library: Library) -> RulesVersion:
    """Version of the rules by which new tasks of a library are made.

    Of scans, and where somebody's own things are to play the parts, the last that don't ask for
    candidates alike in height: too few have four others alike in length, width and height.
    """
    return NEWEST_RULES if library.pool in _MANY and not library.leading else 2


def begin(
    folder: BuildFolder,
    pool: str,
    *,
    public: bool,
    unchecked: bool,
    setup: Setup = UR5_TABLE,
    rules: RulesVersion = NEWEST_RULES,
) -> Salt | None:
    """Begin a build in a folder, or take it up: its salt, and the settings it was begun with.

    Returns:
        The salt; None of a public suite.

    Raises:
        BadData: The folder was begun otherwise, or its salt is missing or another one.
    """
    salt = salt_of(folder, public=public)
    commitment = salt.commitment if salt else None
    other = None if setup == UR5_TABLE else SetupDocument.of(setup)
    folder.claim(
        BuildSettings(
            pool=pool, unchecked=unchecked, commitment=commitment, setup=other, rules=rules
        )
    )
    return salt


def places_of(counts: Mapping[QuestionType, int], first: int) -> list[TaskSlot]:
    """The places of a suite with so many tasks a type, numbered from `first` in each."""
    return [
        TaskSlot(question_type, first + number)
        for question_type, count in counts.items()
        for number in range(count)
    ]


def fill(place: TaskSlot, parts: BuildFolder, resources: BuildResources) -> Iterator[CandidateLog]:
    """Make candidates for a place until one is kept; goes on where an earlier run stopped.

    Yields:
        A line for each candidate, once its result is on disk.

    Raises:
        Unsatisfiable: None of ATTEMPTS seeds gave a task.
    """
    log = parts.log(place)
    if log and log[-1].check == KEPT and parts.task_path(place).exists():
        return
    tried = sum(line.check != KEPT for line in log)
    for number in range(tried, ATTEMPTS):
        start = monotonic()
        attempt = Attempt(place, number, resources.salt, resources.setup, resources.rules)
        result, made = _attempt(attempt, resources)
        solved = made[0].solved if made else None
        if isinstance(result, Rejection):
            check, detail = result.check, result.detail
        elif resources.audit and not any(trial.solved for trial in made):
            parts.keep_unsolved(result.task, resources.library)
            check, detail = UNSOLVED, f"none of {len(made)} attempts"
        else:
            if (attempt.bears, REPEATED) in {(it.seed, it.check) for it in parts.log(place)}:
                return  # another process kept it meanwhile, turned it back, and has gone on
            parts.keep(place, noted(result.task, made), resources.library)
            check, detail = KEPT, ""
        line = CandidateLog(
            place.question_type, attempt.bears, check, solved, detail, monotonic() - start
        )
        parts.add(place, line)
        yield line
        if line.check == KEPT:
            return
    raise Unsatisfiable(
        f"No {place.question_type} task in {ATTEMPTS} candidates for place {place.episode}: "
        f"{why_none(parts.log(place))}. "
        f"{place.question_type.capitalize()} needs {generator_of(place.question_type).needs}."
    )


def why_none(log: Sequence[CandidateLog]) -> str:
    """What most candidates failed by, each with what was measured on one of them."""
    checks = Counter(line.check for line in log if line.check != KEPT).most_common(_REASONS)
    example = {line.check: line.detail for line in reversed(log)}
    return "; ".join(f"{count} by {check!r} ({example[check]})" for check, count in checks)


def assemble(
    path: Path,
    parts: BuildFolder,
    places: Sequence[TaskSlot],
    library: Library,
    salt: Salt | None = None,
) -> None:
    """Join the parts of a suite, in the order of its places; see in_order() for a private one.

    Raises:
        BadData: A part is missing, isn't whole, or isn't of this salt.
    """
    tasks = [task for place in places for task in _kept(place, parts, salt)]
    _write(path, tasks, library, salt)


def assemble_unsolved(
    path: Path,
    parts: BuildFolder,
    places: Sequence[TaskSlot],
    library: Library,
    most: int,
    salt: Salt | None = None,
) -> int:
    """Join candidates that failed only the scripted agents' check, evenly over the places.

    Args:
        path: File for them, a suite.
        parts: Where they lie.
        places: Of which suite.
        library: Has their objects.
        most: How many to take.
        salt: Of a private suite.

    Returns:
        How many there were in all.
    """
    found = list(parts.unsolved(places))
    step = max(1.0, len(found) / most)
    chosen = [found[int(number * step)] for number in range(min(most, len(found)))]
    _write(path, chosen, library, salt)
    return len(found)


def in_order(tasks: Iterable[Task]) -> list[Task]:
    """A private suite's order: by type, then by id, which tells nothing of the place."""
    return sorted(tasks, key=lambda task: (QUESTION_TYPES.index(task.question_type), task.id))


def _write(path: Path, tasks: Sequence[Task], library: Library, salt: Salt | None) -> None:
    states = any(task.version >= ERROR_RULES for task in tasks)
    headline = HEADLINE if states else None
    if salt is None:
        write_suite(path, freeze(path.stem, tuple(tasks), library, headline))
        return
    suite = freeze(path.stem, tuple(in_order(tasks)), library, headline)
    write_suite(path, replace(suite, commitment=salt.commitment))


def _kept(place: TaskSlot, parts: BuildFolder, salt: Salt | None) -> tuple[Task, ...]:
    path = parts.task_path(place)
    tasks = read_suite(path).tasks
    if salt is not None:
        ours = {Attempt(place, number, salt).id for number in range(len(parts.log(place)))}
        if not {task.id for task in tasks} <= ours:
            remedy = "Delete it and its log; its place is then made anew"
            raise BadData(path, "was made with another salt", remedy)
    return tasks


def _attempt(
    attempt: Attempt, resources: BuildResources
) -> tuple[TaskCandidate | Rejection, tuple[SolveAttempt, ...]]:
    result = make(attempt, resources.library, resources.renderer, resources.tables)
    if isinstance(result, Rejection):
        return result, ()
    if restless := RestoredStage.of(result.task.scene, resources.library).unrest():
        return Rejection(RESTLESS, restless), ()
    if alike := look_alike(result.task, resources.library, resources.renderer):
        return Rejection(LOOK_ALIKE, alike), ()
    if resources.audit is None:
        return result, ()
    if wrong := resources.audit(result.task, resources.library, resources.renderer):
        return Rejection(UNVERIFIED, _told(wrong, resources.salt)), ()
    if stuck := immovable(result.task, resources.library, resources.renderer):
        return Rejection(IMMOVABLE, stuck), ()
    return result, trials(result.task, resources.library, resources.renderer)


def _told(wrong: Mapping[str, Sequence[str]], salt: Salt | None) -> str:
    """What is wrong, for a log; of a private suite the checks alone, for others may read that."""
    if salt:
        return ", ".join(wrong)
    return "; ".join(f"{name}: {problem}" for name, found in wrong.items() for problem in found)


def without_notes(task: Task) -> Task:
    """A task as it was generated, before scripted agents tried it."""
    proof = task.certificate
    kept = {name: value for name, value in proof.measures.items() if not name.startswith("solved")}
    return replace(task, certificate=replace(proof, measures=kept))
