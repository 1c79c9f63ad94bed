"""Scenes that are laid once with each answer: does anything that shows tell them apart?

`python benchmarks/internals/worlds.py outputs/worlds --types nested decoys --scenes 60`. Measures
internals, not the public API. Resumable; `--scenes 0` prints what is there.

The generator lays each of five candidates in the hidden place and keeps a scene only if all five
pass, then draws which one is asked about. Here all five are looked at, with one question and one
set of options, so that each of the five letters is right once. Whatever `probe suite shortcuts`'
rules and classifiers find beyond one fifth comes from what differs between the worlds; what is
alike in them gives one fifth exactly. The worlds of five scenes are predicted in one round.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import count
from pathlib import Path
from typing import Annotated

import pydantic
import tyro
from rich.progress import track

from probe.api.resources import Pool, opener, tables_for
from probe.assets.library import Library
from probe.files import write_bytes, write_text
from probe.generation.attempt import Attempt
from probe.generation.build_folder import TaskSlot
from probe.generation.first_look import FirstLook, look_at
from probe.generation.generate import make
from probe.generation.plan import ATTEMPTS
from probe.generation.result import TaskCandidate
from probe.render.renderer import Renderer
from probe.scene.setup import UR5_TABLE, Setup, newest
from probe.shortcuts.investigation import investigate
from probe.shortcuts.sample import CatalogueFacts, LabelledSample, Sample
from probe.shortcuts.table import markdown
from probe.tasks.task import NONE_OF_THE_ABOVE, QuestionType, RulesVersion
from probe.tasks.type_rules import Form

_ROUND = 5
"""Scenes whose worlds are predicted at once."""


@dataclass(frozen=True)
class Worlds:
    """A scene with each of its candidates in the hidden place.

    Attributes:
        form, question, options: What is asked, in all of them.
        right: Place of the right option in each world.
        looks: What the first picture of each shows.
    """

    form: Form
    question: str
    options: tuple[str, ...]
    right: tuple[int, ...]
    looks: tuple[FirstLook, ...]


_DOCUMENT = pydantic.TypeAdapter(Worlds)


@dataclass(frozen=True)
class Maker:
    """What worlds are made with."""

    library: Library
    tables: Sequence[str]
    renderer: Renderer
    setup: Setup
    rules: RulesVersion


def main(
    out: Annotated[Path, tyro.conf.Positional],
    types: tuple[QuestionType, ...],
    scenes: int = 60,
    first: int = 300_000,
    pool: Pool = "evaluation",
    rules: RulesVersion = 3,
    lighting: str = "day_room",
) -> None:
    """Make worlds, then print what rules and classifiers make of them.

    Args:
        out: Folder for them, and for a table a type.
        types: Question types whose generators lay all candidates.
        scenes: Scenes of each type.
        first: Number of the first episode.
        pool: Which objects appear.
        rules: Version of the rules.
        lighting: Of the pictures.
    """
    library = opener(pool)()
    setup = newest(UR5_TABLE, lighting, 2, "filament")
    with Renderer(library.light_cache) as renderer:
        maker = Maker(library, tables_for(pool), renderer, setup, rules)
        for question_type in types:
            folder = out / f"{question_type}-{rules}"
            folder.mkdir(parents=True, exist_ok=True)
            for _ in track(list(_lacking(folder, scenes)), question_type):
                _make(folder, question_type, first, maker)
            _tell(folder, question_type, library)


def _lacking(folder: Path, scenes: int) -> Iterator[int]:
    yield from range(len(_files(folder)), scenes)


def _files(folder: Path) -> list[Path]:
    return sorted(folder.glob("*.json"))


def _make(folder: Path, question_type: QuestionType, first: int, maker: Maker) -> None:
    """Make the worlds of the next episode that has some."""
    done = [int(path.stem) for path in _files(folder)]
    for episode in count(max(done, default=first - 1) + 1):
        found = _candidate(TaskSlot(question_type, episode), maker)
        if found is not None and found.twins:
            worlds = _DOCUMENT.dump_json(_looked_at(found, maker))
            write_bytes(folder / f"{episode}.json", worlds)
            return


def _candidate(place: TaskSlot, maker: Maker) -> TaskCandidate | None:
    """The first attempt at a place that passes; worlds are bare of further checks."""
    for number in range(ATTEMPTS):
        attempt = Attempt(place, number, setup=maker.setup, rules=maker.rules)
        found = make(attempt, maker.library, maker.renderer, maker.tables)
        if isinstance(found, TaskCandidate):
            return found
    return None


def _looked_at(found: TaskCandidate, maker: Maker) -> Worlds:
    task = found.task
    options = [option.text for option in task.options]
    names = [maker.library[id].name for id in task.certificate.candidates]
    right = [options.index(it if it in options else NONE_OF_THE_ABOVE) for it in names]
    assert sorted(right) == list(range(len(options))), f"{task.id}: {names} against {options}"
    looks = [
        look_at(replace(task, scene=twin), maker.library, maker.renderer) for twin in found.twins
    ]
    return Worlds(task.form, task.question, tuple(options), tuple(right), tuple(looks))


def _tell(folder: Path, question_type: QuestionType, library: Library) -> None:
    """Write a table of what rules and classifiers achieve, and print its first lines."""
    examples = [
        example
        for number, path in enumerate(_files(folder))
        for example in _examples(question_type, number, path)
    ]
    table = markdown(investigate(examples, CatalogueFacts(library.specs)))
    write_text(folder.with_suffix(".md"), table)
    print(f"{len(examples)} worlds; {folder.with_suffix('.md')}: {table.splitlines()[0]}")


def _examples(question_type: QuestionType, number: int, path: Path) -> Iterator[LabelledSample]:
    worlds = _DOCUMENT.validate_json(path.read_bytes())
    for right, look in zip(worlds.right, worlds.looks, strict=True):
        sample = Sample(question_type, worlds.form, worlds.question, worlds.options, look)
        yield LabelledSample(f"{path.stem}-{right}", sample, right, number // _ROUND)


if __name__ == "__main__":
    tyro.cli(main)
