"""What grading, suites and scores need to know of Count."""

from probe.tasks.type_rules import TypeRules

RULES = TypeRules(
    forms={"plain": frozenset({"names"})},
    answers="numbers",
    fewest_targets=0,
    # Counting what is visible and adding 0, 1 or 2 is right in a third of the tasks.
    naive=1 / 3,
)
