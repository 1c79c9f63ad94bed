"""What things of a kind weigh by the volume of their hull, and which word names the kind."""

from __future__ import annotations

import csv
from dataclasses import dataclass
from functools import cache
from importlib.resources import files

from probe.assets.collision.hulls import hull_volume
from probe.assets.fitness import PAYLOAD
from probe.types import Array

TABLE = "typical_densities.csv"
UNKNOWN = 400.0
"""Kilograms by cubic metre of hull of what no word names: the middle of the table."""

LIGHTEST, HEAVIEST = 0.003, PAYLOAD
"""Kilograms; a guess alone never makes a thing too heavy for the gripper."""


@dataclass(frozen=True)
class DensityClass:
    """A row of the table.

    Attributes:
        thing: Whether its words are common nouns, not what something is made of or full of.
        words: Each a word, or several that stand side by side.
        density: Kilograms by cubic metre of hull.
    """

    thing: bool
    words: tuple[str, ...]
    density: float


@cache
def kinds() -> tuple[DensityClass, ...]:
    """The rows of the table; the first that fits counts."""
    text = (files("probe.assets") / "data" / TABLE).read_text("utf-8")
    return tuple(
        DensityClass(
            row["kind"] == "thing", tuple(row["words"].split(";")), float(row["kg_per_m3"])
        )
        for row in csv.DictReader(text.splitlines())
    )


def typical_mass(vertices: Array, words: str) -> float:
    """Kilograms of an object, by its hull and the words for it.

    Args:
        vertices: Metres, shape (n, 3).
        words: Its name and category.
    """
    spoken, noun = _spoken(words), category_in(words)
    fitting = [
        kind
        for kind in kinds()
        if (noun in kind.words if kind.thing else any(_place(it, spoken) >= 0 for it in kind.words))
    ]
    density = fitting[0].density if fitting else UNKNOWN
    guess = density * hull_volume(vertices)
    return round(min(max(guess, LIGHTEST), HEAVIEST), 3)


def category_in(name: str) -> str | None:
    """The common noun in a name that says most plainly what it is: the last of the table's.

    What follows "with" isn't what the thing is ("black shoe with orange stripes").
    """
    spoken = _spoken(name.partition(" with ")[0])
    nouns = [word for kind in kinds() if kind.thing for word in kind.words]
    found = [(_place(noun, spoken), noun.count(" "), noun) for noun in nouns]
    found = [(place + spaces, spaces, noun) for place, spaces, noun in found if place >= 0]
    return max(found)[2] if found else None


def _spoken(words: str) -> list[str]:
    return words.lower().replace("-", " ").split()


def _place(phrase: str, spoken: list[str]) -> int:
    """Where a phrase stands last among words, plurals included; -1 if it doesn't."""
    wanted = phrase.split()
    for start in range(len(spoken) - len(wanted), -1, -1):
        here = spoken[start : start + len(wanted)]
        if all(_same(word, want) for word, want in zip(here, wanted, strict=True)):
            return start
    return -1


def _same(word: str, want: str) -> bool:
    return word in (want, f"{want}s", f"{want}es")
