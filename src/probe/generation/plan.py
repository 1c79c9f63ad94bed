"""What an episode is to be like, fixed before any attempt, so that no check can tilt it."""

from __future__ import annotations

import math
from typing import Any

from probe.generation.salt import Salt
from probe.generation.task_generator import generator_of
from probe.generation.task_plan import CROSSED, LETTER, PlannedProperty, TaskPlan
from probe.scene.seeds import generator
from probe.scene.setup import UR5_TABLE, Setup
from probe.tasks.task import NEWEST_RULES, QUESTION_TYPES, QuestionType, RulesVersion
from probe.tasks.type_rules import rules_of
from probe.tasks.wordings import wordings

ATTEMPTS = 1000
"""Of one episode, at most: in a public suite attempt k of episode e has seed 1000 e + k."""

PAIRED: tuple[QuestionType, ...] = tuple(k for k in QUESTION_TYPES if rules_of(k).paired)
"""Types that ask about two marked things."""


def plan(question_type: QuestionType, seed: int) -> TaskPlan:
    """The plan of the episode of a public suite that an attempt's seed belongs to."""
    return plan_of(question_type, seed // ATTEMPTS)


def plan_of(
    question_type: QuestionType,
    episode: int,
    salt: Salt | None = None,
    setup: Setup = UR5_TABLE,
    rules: RulesVersion = NEWEST_RULES,
) -> TaskPlan:
    """The plan of an episode, by its number.

    Each property runs through all its values in every block of consecutive episodes, in an order
    drawn for the block: letters balance over any suite. Whoever has this file can foretell them,
    but where a salt draws the orders.
    """
    texts = wordings(question_type)

    def place_of(turn: PlannedProperty[Any]) -> int:
        block, place = divmod(episode, len(turn.values))
        if salt is None:
            rng = generator(block, "plan", question_type, turn.purpose)
        else:
            rng = salt.generator("plan", question_type, turn.purpose, block)
        return int(rng.permutation(len(turn.values))[place])

    lettered, *others = _turns(question_type)
    letter = lettered.values[place_of(lettered)]
    wording = place_of(PlannedProperty("wording", texts))
    return TaskPlan(
        letter=letter[0],
        wording=wording,
        form=texts[wording].form,
        places={turn.purpose: place_of(turn) for turn in (lettered, *others)},
        setup=setup,
        rules=rules,
    )


def block_of(question_type: QuestionType, seed: int) -> int:
    """A public attempt's block: of episodes that together are even in all that is planned."""
    lengths = [len(turn.values) for turn in _turns(question_type)]
    return seed // ATTEMPTS // math.lcm(len(wordings(question_type)), *lengths)


def _turns(question_type: QuestionType) -> tuple[PlannedProperty[Any], ...]:
    """What a type is planned by, wordings apart; first what begins with the letter."""
    first = CROSSED if rules_of(question_type).paired else LETTER
    return (first, *generator_of(question_type).turns)
