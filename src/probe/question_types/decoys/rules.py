"""What grading, suites and scores need to know of Decoys."""

from probe.tasks.type_rules import TypeRules

RULES = TypeRules(
    forms={"plain": frozenset({"covers"})},
    answers="objects",
    fewest_targets=1,
    copies=True,
    searched="copies",
)
