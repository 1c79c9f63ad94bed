"""Whether find_object finds each named thing by the catalogue's own words.

`python benchmarks/internals/names.py`. Measures internals, not the public API.

Every thing of some scenes that shows enough to be named is asked for by its name and by its
category. The answer is

- alone: it is found, and nothing else fits as well;
- with likes: it fits as well as what is found, and everything that does goes by these words;
- with others: it fits as well as what is found, but so does something of another category;
- not found: something else fits better, or nothing does.

After that, every category that a scene lacks is asked for. The reply says that nothing is called
that, finds a likeness or something that fits in part, and says so, or claims that this is it.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from typing import Literal

import tyro
from phrases import things_of
from rich.console import Console

from probe.api.resources import Pool, library
from probe.perception.matching import match
from probe.perception.things import Thing
from probe.render.renderer import Renderer

Outcome = Literal["alone", "with likes", "with others", "not found"]
Claim = Literal["nothing", "likeness", "in part", "claimed"]
out = Console()


def outcome(words: str, meant: Thing, things: Sequence[Thing]) -> Outcome:
    """What becomes of the name or the category of a thing."""
    found = match(words, things)
    told = () if found is None else (found.thing, *found.others)
    if meant not in told:
        return "not found"
    if len(told) == 1:
        return "alone"
    like = all(thing.words.category == meant.words.category for thing in told)
    return "with likes" if like else "with others"


def claim(category: str, things: Sequence[Thing]) -> Claim:
    """What is said of a category that a scene lacks."""
    found = match(category, things)
    if found is None:
        return "nothing"
    if not found.literal:
        return "likeness"
    return "claimed" if found.whole else "in part"


def main(
    seed: int = 940000, scenes: int = 20, objects: int = 15, pool: Pool = "procedural"
) -> None:
    """Ask for everything in some scenes, and say what isn't found as it should be.

    Args:
        seed: Of the first scene.
        scenes: Their number.
        objects: In each scene.
        pool: The scenes' objects are of it.
    """
    known = library(pool)
    categories = {spec.category for spec in known.specs}
    asked: dict[str, Counter[Outcome]] = {"name": Counter(), "category": Counter()}
    absent = Counter[Claim]()
    with Renderer() as renderer:
        for each in range(seed, seed + scenes):
            things = things_of(each, objects, known, pool, renderer)
            for thing in filter(lambda thing: thing.nameable, things):
                words = {"name": thing.words.called, "category": thing.words.category}
                for which, said in words.items():
                    what = outcome(said, thing, things)
                    asked[which][what] += 1
                    if what in ("with others", "not found"):
                        out.print(each, what, repr(said), markup=False, highlight=False)
            lacking = categories - {thing.words.category for thing in things}
            absent.update(claim(category, things) for category in sorted(lacking))
    for which, counts in asked.items():
        out.print(f"{which}, n = {counts.total()}:", dict(counts))
    out.print(f"absent categories, n = {absent.total()}:", dict(absent))


if __name__ == "__main__":
    tyro.cli(main)
