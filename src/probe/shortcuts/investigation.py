"""Tries every rule and classifier on examples of each type."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from probe.scene.seeds import generator
from probe.shortcuts.classifiers import guesses, models
from probe.shortcuts.families import FAMILIES, LETTERS_ALONE, features
from probe.shortcuts.findings import Finding, Tally, allowed, judge
from probe.shortcuts.rules import rules_for
from probe.shortcuts.sample import Example, Lore
from probe.tasks.task import KINDS


def investigate(examples: Sequence[Example], lore: Lore, *, learning: bool = True) -> list[Finding]:
    """What rules, and classifiers if wanted, achieve on each type, judged together.

    Raises:
        MissingExtra: Classifiers are wanted, and scikit-learn isn't installed.
    """
    tallies: list[Tally] = []
    for kind in KINDS:
        mine = [example for example in examples if example.sample.kind == kind]
        if not mine:
            continue
        tallies += _by_rules(mine, lore)
        tallies += _by_classifiers(mine, lore) if learning else ()
    return judge(tallies)


def _by_rules(examples: Sequence[Example], lore: Lore) -> Iterator[Tally]:
    for name, rule in rules_for(examples[0].sample).items():
        said = [_one_of(rule(e.sample, lore), e.task) for e in examples]
        yield from _tallies(examples, name, said, letters_alone=name.startswith("always"))


def _one_of(places: Sequence[int], task: str) -> int:
    """One of several options, by lot; the same for the same task."""
    return places[int(generator(0, "shortcuts", task).integers(len(places)))]


def _by_classifiers(examples: Sequence[Example], lore: Lore) -> Iterator[Tally]:
    right = [example.right for example in examples]
    for family in FAMILIES:
        told = [features(family, example.sample, lore) for example in examples]
        for name, model in models().items():
            said = guesses(model, told, right)
            if said is not None:
                alone = family in LETTERS_ALONE
                yield from _tallies(examples, f"{name} on {family}", said, letters_alone=alone)


def _tallies(
    examples: Sequence[Example], by: str, said: Sequence[int], *, letters_alone: bool
) -> Iterator[Tally]:
    """Of the type, and of each of its parts."""
    kind = examples[0].sample.kind
    ceiling, allowance = allowed(kind, letters_alone=letters_alone)
    for part in ("", *sorted({example.part for example in examples} - {""})):
        hits = [e.right == s for e, s in zip(examples, said, strict=True) if part in ("", e.part)]
        name = f"{kind}, {part}" if part else kind
        yield Tally(name, by, sum(hits), len(hits), ceiling, allowance)
