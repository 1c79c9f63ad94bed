"""Tries every rule and classifier on examples of each type."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from probe.scene.seeds import generator
from probe.shortcuts.classifiers import guesses, models
from probe.shortcuts.families import FAMILIES, LETTERS_ALONE, features
from probe.shortcuts.findings import Finding, HitCount, allowed, judge
from probe.shortcuts.rules import rules_for
from probe.shortcuts.sample import CatalogueFacts, LabelledSample
from probe.tasks.task import QUESTION_TYPES


def investigate(
    examples: Sequence[LabelledSample], catalogue: CatalogueFacts, *, learning: bool = True
) -> list[Finding]:
    """What rules, and classifiers if wanted, achieve on each type, judged together.

    Raises:
        MissingExtra: Classifiers are wanted, and scikit-learn isn't installed.
    """
    tallies: list[HitCount] = []
    for question_type in QUESTION_TYPES:
        mine = [example for example in examples if example.sample.question_type == question_type]
        if not mine:
            continue
        tallies += _by_rules(mine, catalogue)
        tallies += _by_classifiers(mine, catalogue) if learning else ()
    return judge(tallies)


def _by_rules(examples: Sequence[LabelledSample], catalogue: CatalogueFacts) -> Iterator[HitCount]:
    for name, rule in rules_for(examples[0].sample).items():
        said = {n: _one_of(rule(e.sample, catalogue), e.task) for n, e in enumerate(examples)}
        yield from _tallies(examples, name, said, letters_alone=name.startswith("always"))


def _one_of(places: Sequence[int], task: str) -> int:
    """One of several options, by lot; the same for the same task."""
    return places[int(generator(0, "shortcuts", task).integers(len(places)))]


def _by_classifiers(
    examples: Sequence[LabelledSample], catalogue: CatalogueFacts
) -> Iterator[HitCount]:
    right = [example.right for example in examples]
    blocks = [example.block for example in examples]
    for family in FAMILIES:
        told = [features(family, example.sample, catalogue) for example in examples]
        for name, model in models().items():
            said = guesses(model, told, right, blocks)
            if said:
                alone = family in LETTERS_ALONE
                yield from _tallies(examples, f"{name} on {family}", said, letters_alone=alone)


def _tallies(
    examples: Sequence[LabelledSample], by: str, said: Mapping[int, int], *, letters_alone: bool
) -> Iterator[HitCount]:
    """Of the type, and of each of its parts; `said` has places of options by those of examples."""
    question_type = examples[0].sample.question_type
    ceiling, allowance = allowed(question_type, letters_alone=letters_alone)
    for part in ("", *sorted({example.part for example in examples} - {""})):
        mine = [n for n in said if part in ("", examples[n].part)]
        hits = sum(examples[n].right == said[n] for n in mine)
        name = f"{question_type}, {part}" if part else question_type
        if mine:
            yield HitCount(name, by, hits, len(mine), ceiling, allowance)
