"""What grading, suites and scores need to know of Beneath."""

from probe.tasks.type_rules import TypeRules

RULES = TypeRules(
    forms={"plain": frozenset({"cover"})},
    answers="objects",
    fewest_targets=1,
)
