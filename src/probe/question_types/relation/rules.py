"""What grading, suites and scores need to know of Relation."""

from probe.tasks.type_rules import TypeRules

TURNS = ("clockwise", "anticlockwise")
"""Which way round the ring the question goes, as the picture shows it."""

RULES = TypeRules(
    forms={turn: frozenset({"covers", "name"}) for turn in TURNS},
    answers="objects",
    fewest_targets=2,
    copies=True,
    bystanders=1,
)
