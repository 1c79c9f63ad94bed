"""What grading, suites and scores need to know of Find."""

from probe.tasks.type_rules import TypeRules

RULES = TypeRules(
    forms={"plain": frozenset()},
    answers="objects",
    fewest_targets=1,
    pointed=True,
    strata=True,
    searched="table",
)
