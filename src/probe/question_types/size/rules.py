"""What grading, suites and scores need to know of Size."""

from probe.tasks.type_rules import TypeRules

RULES = TypeRules(
    forms={"longer": frozenset(), "larger": frozenset(), "smaller": frozenset()},
    answers="marks",
    fewest_targets=2,
)
