"""What grading, suites and scores need to know of Nested."""

from probe.tasks.type_rules import TypeRules

RULES = TypeRules(
    forms={"plain": frozenset({"cover"})},
    answers="objects",
    fewest_targets=1,
)
