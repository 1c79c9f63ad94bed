"""What grading, suites and scores need to know of Reduce."""

from probe.tasks.type_rules import TypeRules

RULES = TypeRules(
    forms={"plain": frozenset({"names"})},
    answers="objects",
    fewest_targets=1,
)
