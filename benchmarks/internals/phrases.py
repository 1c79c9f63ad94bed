"""Whether find_object finds what people mean by their own words.

`python benchmarks/internals/phrases.py PHRASES.json`. Measures internals, not the public API.

The file is a list of `{"seed": 7, "place": [512, 300], "phrase": "white box"}`: what a person who
saw the scene of that seed calls the thing at that place, (u, v) in the top picture's pixels. Draw
the pictures with `probe scene 7`. Each phrase is

- right: it finds that thing;
- listed: it doesn't, but the reply lists that thing with an object_id;
- wrong: it finds another thing, and doesn't list that thing;
- missed: it says that nothing is called that, and lists other things alone;
- nothing: the reply names no thing at all;
- unseen: perception makes out nothing at that place.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Annotated, Literal

import pydantic
import tyro
from rich.console import Console

from probe.api.resources import Pool, library, tables_for
from probe.assets.library import Library
from probe.perception.matching import match, nearest
from probe.perception.oracle import Oracle
from probe.perception.things import Thing
from probe.render.photograph import load_scene, measure, photograph
from probe.render.renderer import Renderer
from probe.toolshed.findings import told_things
from probe.world.scenes import make_scene

Outcome = Literal["right", "listed", "wrong", "missed", "nothing", "unseen"]
out = Console()


class Phrase(pydantic.BaseModel, frozen=True, extra="forbid"):
    """What somebody called the thing at a place of a scene."""

    seed: int
    place: tuple[int, int]
    phrase: str


def outcome(phrase: Phrase, things: Sequence[Thing]) -> tuple[Outcome, str]:
    """What becomes of a phrase, and the first thing that it brings up."""
    u, v = phrase.place
    meant = next((thing for thing in things if thing.mask[v, u]), None)
    found = match(phrase.phrase, things)
    told = told_things(found) if found else nearest(phrase.phrase, things)
    called = told[0].words.name or told[0].words.description if told else ""
    if meant is None:
        return "unseen", called
    if found and found.thing is meant:
        return "right", called
    if meant in told:
        return "listed", called
    if found:
        return "wrong", called
    return ("missed" if told else "nothing"), called


def things_of(
    seed: int, objects: int, things: Library, pool: Pool, renderer: Renderer
) -> Sequence[Thing]:
    """What the oracle makes out in a scene's top picture."""
    scene = make_scene(seed, things, tables_for(pool), objects)
    load_scene(renderer, scene, things, things.table(scene.table))
    shares = {number: seen.fraction for number, seen in measure(renderer, scene).items()}
    frame = replace(photograph(renderer, scene), shares=shares)
    words = {placed.instance: things[placed.object_id] for placed in scene.objects}
    poses = {placed.instance: placed.pose for placed in scene.objects}
    return Oracle(words, lambda: poses).detect(frame)


def main(
    phrases: Annotated[Path, tyro.conf.Positional],
    objects: int = 15,
    pool: Pool = "procedural",
) -> None:
    """Say what becomes of each phrase, and how many come out how.

    Args:
        phrases: A JSON file.
        objects: In each scene, as they were when the pictures were drawn.
        pool: The scenes' objects are of it.
    """
    said = pydantic.TypeAdapter(list[Phrase]).validate_json(phrases.read_text("utf-8"))
    with Renderer() as renderer:
        known = library(pool)
        seeds = dict.fromkeys(phrase.seed for phrase in said)
        seen = {seed: things_of(seed, objects, known, pool, renderer) for seed in seeds}
    counts = Counter[Outcome]()
    for phrase in said:
        what, called = outcome(phrase, seen[phrase.seed])
        counts[what] += 1
        u, v = phrase.place
        line = f"{what:8}{phrase.seed} ({u}, {v}) {phrase.phrase!r} -> {called}"
        out.print(line, soft_wrap=True, highlight=False, markup=False)
    out.print(f"n = {len(said)}:", ", ".join(f"{what} {count}" for what, count in counts.items()))


if __name__ == "__main__":
    tyro.cli(main)
