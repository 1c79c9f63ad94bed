"""What grading, suites and scores need to know of Budgeted."""

from probe.tasks.type_rules import TypeRules

MANIPULATIONS = 3
"""Grasps and pushes that its questions allow."""

RULES = TypeRules(
    forms={"plain": frozenset({"covers", "length"})},
    answers="objects",
    fewest_targets=1,
)
