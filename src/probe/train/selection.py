"""Which of a teacher's episodes to learn from, and why the others aren't. Pure."""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from itertools import zip_longest

from probe.episodes.record import EpisodeRecord
from probe.errors import BadData
from probe.scene.seeds import generator
from probe.tasks.suite_file import digest_of
from probe.tasks.task import Task
from probe.train.efficiency import SLACK, limits, waste
from probe.train.evaluation import Evaluation, Refusal


@dataclass(frozen=True)
class Candidate:
    """An episode.

    Attributes:
        task: What it was about.
        record: What happened.
        correct: Whether it was right; None for our fault.
    """

    task: Task
    record: EpisodeRecord
    correct: bool | None

    @property
    def direct(self) -> bool:
        """Whether it had no tools."""
        return self.record.arm.split(",")[0] == "direct"


@dataclass(frozen=True)
class Recipe:
    """How to choose.

    Attributes:
        counts: Examples of each type at most; a type that isn't named gives all it has.
        direct_share: Part of a type's examples that may be without tools.
        slack: Manipulations over the type's median that are let pass.
        seed: Chooses among equals.
    """

    counts: Mapping[str, int] = field(default_factory=dict[str, int])
    direct_share: float = 0.5
    slack: int = SLACK
    seed: int = 0


@dataclass(frozen=True)
class Selection:
    """What was chosen.

    Attributes:
        chosen: In order of type and task.
        refused: Tasks that belong to evaluation.
        dropped: How many episodes were left out, by reason.
        limits: The most manipulations that were let pass, by type.
    """

    chosen: tuple[Candidate, ...]
    refused: tuple[Refusal, ...]
    dropped: Counter[str]
    limits: Mapping[str, int]


def select(candidates: Sequence[Candidate], evaluation: Evaluation, recipe: Recipe) -> Selection:
    """Choose.

    Raises:
        BadData: A type was asked for of which there is nothing to choose.
    """
    dropped = Counter[str]()
    allowed, refused = _allowed(candidates, evaluation)
    dropped["of evaluation"] = len(candidates) - len(allowed)
    agentic = [it for it in allowed if it.correct and not it.direct]
    most = limits([(it.task.kind, it.record) for it in agentic], recipe.slack)
    tasks = _usable_by_task(allowed, most, dropped)
    chosen = list[Candidate]()
    for kind in sorted({*(ways[0].task.kind for ways in tasks), *recipe.counts}):
        mine = [ways for ways in tasks if ways[0].task.kind == kind]
        wanted = recipe.counts.get(kind, len(mine))
        if wanted and not mine:
            raise BadData(
                kind,
                f"{wanted} examples are wanted, but no episode of this type can be learnt from",
                f"Collect more, or say --counts.{kind} 0",
            )
        chosen += _balanced(_mixed(mine, wanted, recipe), wanted, recipe)
    dropped["another of its task, or more than wanted"] += sum(map(len, tasks)) - len(chosen)
    return Selection(tuple(chosen), tuple(refused), +dropped, most)


def _allowed(
    candidates: Sequence[Candidate], evaluation: Evaluation
) -> tuple[list[Candidate], list[Refusal]]:
    refusals = {it.task.id: evaluation.refusal(it.task) for it in candidates}
    refused = [refusal for refusal in refusals.values() if refusal is not None]
    return [it for it in candidates if refusals[it.task.id] is None], refused


_Ways = Sequence[Candidate]
"""Of one task all episodes to learn from: at most one is taken, the first that fits."""


def _usable_by_task(
    candidates: Sequence[Candidate], most: Mapping[str, int], dropped: Counter[str]
) -> list[_Ways]:
    by_task: defaultdict[str, list[Candidate]] = defaultdict(list)
    for it in candidates:
        by_task[digest_of(it.task)].append(it)
    found = [_usable(tried, most, dropped) for tried in by_task.values()]
    return [ways for ways in found if ways]


def _usable(
    tried: Sequence[Candidate], most: Mapping[str, int], dropped: Counter[str]
) -> list[Candidate]:
    """Those to learn from: without tools if it was right like that each time, then the shortest."""
    without = [it for it in tried if it.direct]
    lucky = not all(it.correct for it in without)
    usable = list[Candidate]()
    for it in tried:
        reason = None
        if not it.correct:
            reason = "missing" if it.correct is None else "wrong or unanswered"
        elif it.direct and lucky:
            reason = "right without tools, but not each time"
        elif not it.direct:
            reason = waste(it.record, most[it.task.kind])
        if reason is None:
            usable.append(it)
        else:
            dropped[reason] += 1
    return sorted(usable, key=_length)


def _length(it: Candidate) -> tuple[bool, int, int, int]:
    return not it.direct, it.record.manipulations, len(it.record.steps), it.record.run


def _mixed(mine: Sequence[_Ways], wanted: int, recipe: Recipe) -> list[Candidate]:
    """One episode a task, no more of them without tools than the recipe's share of all.

    Where that is reached, a task is shown with tools if the teacher solved it like that as well.
    """
    ways = {each[0].task.id: each for each in mine}
    direct = _shuffled([each[0] for each in mine if each[0].direct], recipe)
    agentic = [each[0] for each in mine if not each[0].direct]
    share = recipe.direct_share
    most = wanted * share
    if share < 1:
        # What comes out may be less than is wanted.
        most = min(most, share / (1 - share) * len(agentic))
    taken = int(most + 1e-9)
    others = [
        next((way for way in ways[it.task.id] if not way.direct), None) for it in direct[taken:]
    ]
    return [*agentic, *direct[:taken], *(it for it in others if it is not None)]


def _balanced(mine: Sequence[Candidate], wanted: int, recipe: Recipe) -> list[Candidate]:
    """So many, letters in turn as far as they are there; in order of tasks."""
    by_letter: defaultdict[str, list[Candidate]] = defaultdict(list)
    for it in _shuffled(mine, recipe):
        by_letter[it.task.answer].append(it)
    turns = zip_longest(*(by_letter[letter] for letter in sorted(by_letter)))
    in_turn = [it for turn in turns for it in turn if it is not None]
    return sorted(in_turn[:wanted], key=lambda it: (it.task.seed, it.task.id))


def _shuffled(some: Sequence[Candidate], recipe: Recipe) -> list[Candidate]:
    """In an order that depends on nothing but each task and the recipe's seed."""
    keys = {it.task.id: generator(recipe.seed, "select", it.task.id).random() for it in some}
    return sorted(some, key=lambda it: (keys[it.task.id], it.task.id))
