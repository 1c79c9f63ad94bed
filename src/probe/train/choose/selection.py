"""Which of a teacher's episodes to learn from, and why the others aren't. Pure."""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import zip_longest

from probe.errors import BadData
from probe.scene.seeds import generator
from probe.tasks.suite_file import digest_of
from probe.tasks.task import QuestionType
from probe.train.choose.candidates import EpisodeCandidate, Ways, usable_by_task
from probe.train.choose.efficiency import SLACK, limits
from probe.train.choose.evaluation import Evaluation, TrainingRefusal

BEYOND_SHARE = "without tools, beyond --direct-share"
"""Why an episode was left out that would be wanted, if its task had been solved with tools."""


@dataclass(frozen=True)
class Recipe:
    """How to choose.

    Attributes:
        counts: Examples of each type at most; a type that isn't named gives all it has.
        direct_share: Part of a type's examples that may be without tools.
        slack: Manipulations over the type's median that are let pass.
        least: Manipulations that an episode with tools must have. Where most examples of a type
            end at the first look, a small student ends there as well.
        seed: Chooses among equals. A type's examples are among those of a larger count.
        total: Examples of all types, in the proportions of what can be had of each; None for as
            many as there are.
    """

    counts: Mapping[QuestionType, int] = field(default_factory=dict[QuestionType, int])
    direct_share: float = 0.5
    slack: int = SLACK
    seed: int = 0
    total: int | None = None
    least: int = 0


@dataclass(frozen=True)
class Selection:
    """What was chosen.

    Attributes:
        chosen: In order of type and task.
        refused: Tasks that belong to evaluation.
        dropped: How many episodes were left out, by reason.
        limits: The most manipulations that were let pass, by type.
    """

    chosen: tuple[EpisodeCandidate, ...]
    refused: tuple[TrainingRefusal, ...]
    dropped: Counter[str]
    limits: Mapping[str, int]


def select(
    candidates: Sequence[EpisodeCandidate], evaluation: Evaluation, recipe: Recipe
) -> Selection:
    """Choose.

    Raises:
        BadData: A type was asked for of which nothing can be chosen, or there are fewer examples
            than the total.
    """
    dropped = Counter[str]()
    allowed, refused = _allowed(candidates, evaluation)
    dropped["of evaluation"] = len(candidates) - len(allowed)
    agentic = [it for it in allowed if it.correct and not it.direct]
    most = limits([(it.task.question_type, it.record) for it in agentic], recipe.slack)
    enough = [it for it in allowed if not it.correct or _has_enough(it, recipe)]
    dropped["fewer manipulations than --least"] = len(allowed) - len(enough)
    tasks = usable_by_task(enough, most, dropped)
    by_type: defaultdict[QuestionType, list[Ways]] = defaultdict(list)
    for ways in tasks:
        by_type[ways[0].task.question_type].append(ways)
    recipe = replace(recipe, counts=_counts(by_type, recipe))
    chosen = list[EpisodeCandidate]()
    for question_type in sorted({*by_type, *recipe.counts}):
        mine = by_type[question_type]
        wanted = recipe.counts.get(question_type, len(mine))
        mixed, left = _mixed(mine, wanted, recipe)
        picked = _balanced(mixed, wanted, recipe)
        if recipe.counts.get(question_type) and not picked:
            raise _nothing(question_type, recipe, without_tools=bool(mine))
        if len(picked) < wanted:
            dropped[BEYOND_SHARE] += sum(map(len, left))
        chosen += picked
    rest = sum(map(len, tasks)) - len(chosen) - dropped[BEYOND_SHARE]
    dropped["another of its task, or more than wanted"] += rest
    return Selection(tuple(chosen), tuple(refused), +dropped, most)


def _has_enough(it: EpisodeCandidate, recipe: Recipe) -> bool:
    return it.direct or it.record.manipulations >= recipe.least


def _counts(
    by_type: Mapping[QuestionType, Sequence[Ways]], recipe: Recipe
) -> Mapping[QuestionType, int]:
    """Examples of each type at most.

    A total is shared by Webster's method, by which a larger one takes from no type.
    """
    if recipe.total is None:
        return recipe.counts
    can_be_had = dict[QuestionType, int]()
    for question_type, mine in by_type.items():
        mixed, _ = _mixed(mine, len(mine), recipe)
        can_be_had[question_type] = min(len(mixed), recipe.counts.get(question_type, len(mixed)))
    if sum(can_be_had.values()) < recipe.total:
        reason = f"wants {recipe.total} examples, and {sum(can_be_had.values())} can be had"
        raise BadData("--total", reason, "Collect more, or say a smaller number")
    turns = sorted(
        ((place + 0.5) / count, question_type)
        for question_type, count in can_be_had.items()
        for place in range(count)
    )
    taken = Counter(question_type for _, question_type in turns[: recipe.total])
    return {question_type: taken[question_type] for question_type in can_be_had}


def _allowed(
    candidates: Sequence[EpisodeCandidate], evaluation: Evaluation
) -> tuple[list[EpisodeCandidate], list[TrainingRefusal]]:
    # By content: an id tells a task's type and seed alone.
    verdicts: dict[str, TrainingRefusal | None] = {}
    allowed = list[EpisodeCandidate]()
    for it in candidates:
        digest = digest_of(it.task)
        if digest not in verdicts:
            verdicts[digest] = evaluation.refusal(it.task)
        if verdicts[digest] is None:
            allowed.append(it)
    return allowed, [verdict for verdict in verdicts.values() if verdict is not None]


def _nothing(question_type: QuestionType, recipe: Recipe, *, without_tools: bool) -> BadData:
    """What is told of a type that was asked for in vain: all of it is without tools, or none."""
    reason = f"{recipe.counts[question_type]} examples are wanted, but "
    if without_tools:
        reason += "it was solved without tools alone, and --direct-share "
        reason += f"{recipe.direct_share:g} wants some with tools beside these"
        remedy = "Say --direct-share 1, collect with --settings agentic"
    else:
        reason += "no episode of this type can be learnt from"
        remedy = "Collect more"
    return BadData(question_type, reason, f"{remedy}, or say --counts {question_type} 0")


def _mixed(
    mine: Sequence[Ways], wanted: int, recipe: Recipe
) -> tuple[list[EpisodeCandidate], list[Ways]]:
    """One episode a task, no more of them without tools than the recipe's share of all.

    Where that is reached, a task is shown with tools if the teacher solved it like that as well;
    those that weren't are left, and come second.
    """
    agentic = [ways[0] for ways in mine if not ways[0].direct]
    direct = [ways for ways in mine if ways[0].direct]
    direct.sort(key=lambda ways: _place(ways[0], recipe))
    share = recipe.direct_share
    most = wanted * share
    if share < 1:
        # What comes out may be less than is wanted.
        most = min(most, share / (1 - share) * len(agentic))
    taken = int(most + 1e-9)
    mixed, left = [*agentic, *(ways[0] for ways in direct[:taken])], list[Ways]()
    for ways in direct[taken:]:
        other = next((way for way in ways if not way.direct), None)
        if other is None:
            left.append(ways)
        else:
            mixed.append(other)
    return mixed, left


def _balanced(
    mine: Sequence[EpisodeCandidate], wanted: int, recipe: Recipe
) -> list[EpisodeCandidate]:
    """So many, letters in turn as far as they are there; in order of tasks."""
    by_letter: defaultdict[str, list[EpisodeCandidate]] = defaultdict(list)
    for it in sorted(mine, key=lambda it: _place(it, recipe)):
        by_letter[it.task.answer].append(it)
    turns = zip_longest(*(by_letter[letter] for letter in sorted(by_letter)))
    in_turn = [it for turn in turns for it in turn if it is not None]
    return sorted(in_turn[:wanted], key=lambda it: (it.task.seed, it.task.id))


def _place(it: EpisodeCandidate, recipe: Recipe) -> tuple[float, str]:
    """Its place among equals, which depends on nothing but its task and the recipe's seed."""
    return generator(recipe.seed, "select", it.task.id).random(), it.task.id
