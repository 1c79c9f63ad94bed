"""Builds a suite: candidates, their checks, the solvable check; place by place, resumable."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from time import monotonic

from probe.assets.library import Library
from probe.certify.generate import generate
from probe.certify.needs import NEEDS
from probe.certify.parts import KEPT, RESTLESS, UNSOLVED, Line, Parts, Place
from probe.certify.plan import ATTEMPTS
from probe.certify.restaged import Restaged
from probe.certify.result import Candidate, Rejection
from probe.certify.solve import Trial, noted, trials
from probe.errors import Unsatisfiable
from probe.render.renderer import Renderer
from probe.tasks.suite import freeze
from probe.tasks.suite_file import read_suite, write_suite
from probe.tasks.task import QuestionKind, Task

_REASONS = 3


@dataclass(frozen=True)
class Workshop:
    """What tasks are made with.

    Attributes:
        unchecked: Leave out the scripted agents' check: for tests of the generator alone.
    """

    library: Library
    tables: Sequence[str]
    renderer: Renderer
    unchecked: bool = False


def places_of(counts: Mapping[QuestionKind, int], first: int) -> list[Place]:
    """The places of a suite with so many tasks a type, numbered from `first` in each."""
    return [
        Place(kind, first + number) for kind, count in counts.items() for number in range(count)
    ]


def fill(place: Place, parts: Parts, workshop: Workshop) -> Iterator[Line]:
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
    for seed in range(place.episode * ATTEMPTS + tried, (place.episode + 1) * ATTEMPTS):
        start = monotonic()
        result, made = _attempt(place.kind, seed, workshop)
        solved = made[0].solved if made else None
        if isinstance(result, Rejection):
            check, detail = result.check, result.detail
        elif not workshop.unchecked and not any(trial.solved for trial in made):
            parts.keep_unsolved(result.task, workshop.library)
            check, detail = UNSOLVED, f"none of {len(made)} attempts"
        else:
            parts.keep(place, noted(result.task, made), workshop.library)
            check, detail = KEPT, ""
        line = Line(place.kind, seed, check, solved, detail, monotonic() - start)
        parts.add(place, line)
        yield line
        if line.check == KEPT:
            return
    raise Unsatisfiable(
        f"No {place.kind} task in {ATTEMPTS} candidates for place {place.episode}: "
        f"{why_none(parts.log(place))}. {place.kind.capitalize()} needs {NEEDS[place.kind]}."
    )


def why_none(log: Sequence[Line]) -> str:
    """What most candidates failed by, each with what was measured on one of them."""
    checks = Counter(line.check for line in log if line.check != KEPT).most_common(_REASONS)
    example = {line.check: line.detail for line in reversed(log)}
    return "; ".join(f"{count} by {check!r} ({example[check]})" for check, count in checks)


def assemble(path: Path, parts: Parts, places: Sequence[Place], library: Library) -> None:
    """Join the parts of a suite in the order of its places, with the whole log beside it.

    Raises:
        BadData: A part is missing or isn't whole.
    """
    tasks = [task for place in places for task in read_suite(parts.task_path(place)).tasks]
    write_suite(path, freeze(path.stem, tuple(tasks), library))


def assemble_unsolved(
    path: Path, parts: Parts, places: Sequence[Place], library: Library, most: int
) -> int:
    """Join candidates that failed only the scripted agents' check, evenly over the places.

    Args:
        path: File for them, a suite.
        parts: Where they lie.
        places: Of which suite.
        library: Has their objects.
        most: How many to take.

    Returns:
        How many there were in all.
    """
    found = list(parts.unsolved(places))
    step = max(1.0, len(found) / most)
    chosen = [found[int(number * step)] for number in range(min(most, len(found)))]
    write_suite(path, freeze(path.stem, tuple(chosen), library))
    return len(found)


def _attempt(
    kind: QuestionKind, seed: int, workshop: Workshop
) -> tuple[Candidate | Rejection, tuple[Trial, ...]]:
    result = generate(kind, seed, workshop.library, workshop.renderer, workshop.tables)
    if isinstance(result, Rejection):
        return result, ()
    if restless := Restaged.of(result.task.scene, workshop.library).unrest():
        return Rejection(RESTLESS, restless), ()
    if workshop.unchecked:
        return result, ()
    table = workshop.library.table(result.task.scene.table)
    return result, trials(result.task, workshop.library, table, workshop.renderer)


def without_notes(task: Task) -> Task:
    """A task as it was generated, before scripted agents tried it."""
    proof = task.certificate
    kept = {name: value for name, value in proof.measures.items() if not name.startswith("solved")}
    return replace(task, certificate=replace(proof, measures=kept))
