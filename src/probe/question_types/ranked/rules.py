"""What grading, suites and scores need to know of Ranked."""

from probe.tasks.type_rules import TypeRules

RANKS = ("longest", "second", "shortest")
"""What may be asked for; a form's place here is that of the answer, the longest first."""

RULES = TypeRules(
    forms={rank: frozenset({"covers"}) for rank in RANKS},
    answers="objects",
    fewest_targets=len(RANKS),
    copies=True,
    rivals=True,
)
