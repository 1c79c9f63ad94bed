"""What grading, suites and scores need to know of Compare."""

from probe.tasks.type_rules import TypeRules

RULES = TypeRules(
    forms={
        "colour": frozenset({"colour"}),
        "darker": frozenset(),
        "like": frozenset({"name"}),
    },
    answers="marks",
    fewest_targets=2,
)
