"""Imaginary tasks whose answers follow from nothing, or from one thing that was planted.

To see what the no-shortcut test finds; no real task comes from here.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from probe.assets.spec import ObjectSpec
from probe.generation.first_look import FirstLook, VisibleThing
from probe.perception.scene_graph import Relation
from probe.shortcuts.sample import CatalogueFacts, LabelledSample, Sample
from probe.tasks.task import NONE_OF_THE_ABOVE, PAIR, QuestionType
from probe.tasks.type_rules import Form

_COLOURS = ("red", "green", "blue", "yellow", "white", "black")
_CATEGORIES = ("mug", "brick", "egg", "die", "pawn", "coin", "lid", "cork", "nut", "key")
_WORDINGS = tuple(f"{word} is it that lies there" for word in ("What", "Which", "Name what", "Say"))

_BLOCK = 40
"""Letters are even in this many tasks."""


def _spec(name: str, size: float) -> ObjectSpec:
    colour, category = name.split(" ", 1)
    shape = (size, size * 0.7, size * 0.5)
    return ObjectSpec(
        name.replace(" ", "_"), name, category, (colour,), name, 0.1, 0.5, shape, False,
        "procedural", "CC0-1.0", "test",
    )  # fmt: skip


LORE = CatalogueFacts(
    tuple(
        _spec(f"{colour} {category}", 0.04 + 0.001 * (7 * i + j))
        for i, colour in enumerate(_COLOURS)
        for j, category in enumerate(_CATEGORIES)
    )
)


def _sight(name: str | None, rng: np.random.Generator) -> VisibleThing:
    left, top, wide, high = (int(v) for v in rng.integers((0, 0, 20, 20), (800, 800, 200, 200)))
    lab = (float(rng.uniform(5, 95)), *rng.uniform(-50, 50, size=2).tolist())
    return VisibleThing(
        name,
        name.split(" ", 1)[1] if name else "",
        (str(rng.choice(_COLOURS)),),
        int(rng.uniform(0.2, 0.9) * wide * high),
        (left, top, left + wide, top + high),
        lab,
        float(rng.uniform(0, 0.6)),
        float(rng.uniform(0.01, 0.1)),
        float(rng.uniform(0, 0.5)),
    )


@dataclass
class ImaginaryTask:
    """One task in the making: what a leak may change before it is put together.

    Attributes:
        rng: The task's own.
        right: Place of the right option.
        options, question, question_type, form: As in Sample; the question without its mark.
        things, marked, contacts: As in FirstLook.
    """

    rng: np.random.Generator
    options: list[str]
    right: int
    question: str
    things: list[VisibleThing]
    question_type: QuestionType = "find"
    form: Form = "plain"
    marked: tuple[int, ...] = ()
    contacts: tuple[Relation, ...] = ()

    def example(self, number: int) -> LabelledSample:
        """The task, put together."""
        marked = dict(zip(PAIR, self.marked, strict=False))
        look = FirstLook(tuple(self.things), self.contacts, marked)
        question = f"{self.question}?"
        sample = Sample(self.question_type, self.form, question, tuple(self.options), look)
        return LabelledSample(
            f"{self.question_type}-{number:04}", sample, self.right, number // _BLOCK
        )


Make = Callable[[np.random.Generator, int], ImaginaryTask]
"""Makes a task; the number, 0 to 9, is a lot that occurs once in ten tasks, for its letter."""

Leak = Callable[[ImaginaryTask], None]


def offer(draw: ImaginaryTask, candidates: Sequence[str], truth: int) -> None:
    """Offer four of five, so that the last option is right in a fifth of all tasks."""
    others = [text for place, text in enumerate(candidates) if place != truth]
    others = [others[int(place)] for place in draw.rng.permutation(len(others))]
    if draw.right < 4:
        others[draw.right] = candidates[truth]
    draw.options = [*others, NONE_OF_THE_ABOVE]


def find(rng: np.random.Generator, lot: int) -> ImaginaryTask:
    """A question of five options that are objects."""
    names = [LORE.specs[int(n)].name for n in rng.choice(len(LORE.specs), 15, replace=False)]
    things = [_sight(name if rng.random() < 0.8 else None, rng) for name in names[5:]]
    draw = ImaginaryTask(rng, [], lot % 5, str(rng.choice(_WORDINGS)), things)
    offer(draw, names[:5], int(rng.integers(5)))
    return draw


def count(rng: np.random.Generator, lot: int, hidden: int | None = None) -> ImaginaryTask:
    """A question of numbers; so many are hidden, else 0 to 2."""
    name = LORE.specs[int(rng.integers(len(LORE.specs)))].name
    seen, hidden = int(rng.integers(4)), int(rng.integers(3)) if hidden is None else hidden
    near = [seen, seen + 1, seen + 2]
    rest = [n for n in range(6) if n not in near]
    candidates = sorted([*near, *rng.choice(rest, 2, replace=False).tolist()])
    others = [LORE.specs[int(n)].name for n in rng.choice(len(LORE.specs), 8, replace=False)]
    things = [_sight(name, rng) for _ in range(seen)]
    things += [_sight(other, rng) for other in others if other != name]
    asked = f"{rng.choice(_WORDINGS)}: how many {name}s"
    draw = ImaginaryTask(rng, [], lot % 5, asked, things, "count")
    offer(draw, [str(n) for n in candidates], candidates.index(seen + hidden))
    return draw


def size(rng: np.random.Generator, lot: int) -> ImaginaryTask:
    """A question which of two is larger."""
    return _pair(rng, lot, "size", ("longer", "larger", "smaller"))


def compare(rng: np.random.Generator, lot: int) -> ImaginaryTask:
    """A question which of two has a colour."""
    return _pair(rng, lot, "compare", ("colour", "darker"))


def _pair(
    rng: np.random.Generator, lot: int, question_type: QuestionType, forms: tuple[Form, ...]
) -> ImaginaryTask:
    things = [_sight(None, rng) for _ in range(12)]
    covers = Relation(2, "covering", 0), Relation(3, "covering", 1)
    form = forms[int(rng.integers(len(forms)))]
    word = f" {rng.choice(_COLOURS)}" if form == "colour" else ""
    right, question = lot % 2, f"{rng.choice(_WORDINGS)}: the {form} one{word}"
    return ImaginaryTask(
        rng, ["Object A", "Object B"], right, question, things, question_type, form, (0, 1), covers
    )


def examples(make: Make, n: int, leak: Leak | None = None, seed: int = 0) -> list[LabelledSample]:
    """So many tasks; a leak, if any, may change each."""
    found: list[LabelledSample] = []
    for number in range(n):
        lots = np.random.default_rng([seed, n, number // 10]).permutation(10)
        draw = make(np.random.default_rng([seed, number]), int(lots[number % 10]))
        if leak:
            leak(draw)
        found.append(draw.example(number))
    return found
