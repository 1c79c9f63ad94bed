"""What grading, suites and scores need to know of Behind."""

from probe.tasks.type_rules import TypeRules

RULES = TypeRules(
    forms={"plain": frozenset({"occluder"})},
    answers="objects",
    fewest_targets=1,
)
