"""What grading, suites and scores need to know of Exact."""

from probe.tasks.type_rules import TypeRules

RULES = TypeRules(
    forms={"plain": frozenset({"names"})},
    answers="objects",
    fewest_targets=1,
    exact=True,
)
