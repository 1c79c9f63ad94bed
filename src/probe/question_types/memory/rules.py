"""What grading, suites and scores need to know of Memory."""

from probe.tasks.type_rules import TypeRules

RULES = TypeRules(
    forms={"plain": frozenset({"names", "cover"})},
    answers="objects",
    fewest_targets=1,
    exact=True,
    bystanders=2,
)
