"""Suites of tasks: those of the package, those in files, and new ones."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

from probe.api.progress import Track, silent
from probe.api.resources import EVALUATION_POOL, Pool, opener, tables_for
from probe.assets.library import Library
from probe.generation.build import BuildResources, assemble, begin, fill, places_of, rules_for
from probe.generation.build_folder import BuildFolder, TaskSlot
from probe.generation.repeats import turned_back
from probe.render.renderer import Renderer
from probe.scene.setup import ROOM_TABLE, Setup
from probe.tasks.suite import Suite
from probe.tasks.suite_file import check_new_name, find_suite
from probe.tasks.task import QuestionType
from probe.verification.check import what_is_wrong


def open_library(pool: Pool = "procedural") -> Library:
    """The objects that can be placed on a table.

    Args:
        pool: "train" or "evaluation" (made by formula, need no files; near-duplicates are never
            on both sides), "procedural-2" (both), "procedural" (its first edition, 965 objects,
            all for evaluation), "scans" (needs the folder that PROBE_ASSETS names), "own" (those
            you imported), "own+procedural", or "all".

    Returns:
        A library: `library.specs` lists its objects, `library[id]` is one of them.

    Raises:
        BadData: Scans or own objects are wanted and their folder isn't there.
    """
    return opener(pool)()


def load_suite(name: str | Path) -> Suite:
    """Load a suite: one that comes with the package, or a file.

    The package has "v2", "v1", "v1.1", "v1-scans", "v1-unfiltered", "behind", "demo" and "tour".

    Raises:
        UnknownName: It is neither.
        BadData: The file isn't a whole suite, or isn't the packaged one whose name it bears.
    """
    return find_suite(str(name))


def build_suite(
    out: str | Path,
    counts: Mapping[QuestionType, int],
    *,
    pool: Pool = EVALUATION_POOL,
    public: bool = False,
    first: int = 0,
    certified: bool = True,
    setup: Setup | None = None,
    track: Track = silent,
) -> Suite:
    """Make, check and freeze tasks; continues where an earlier call stopped.

    Args:
        out: File for the suite. Kept tasks and the log wait in a folder beside it, with the
            secret salt that decides letters, order and ids.
        counts: Tasks of each question type: {"beneath": 4, "find": 4}.
        pool: Which objects appear, by default those for evaluation; see open_library(). The suite
            says it.
        public: Draw no salt: anyone can reproduce these tasks, and predict their answers.
        first: With `public`, number of the first episode of each type.
        certified: Keep only tasks that hold when they are measured once more, and that a scripted
            agent solves; this takes most of the time.
        setup: The table that the tasks are for; see read_setup(). By default the usual one, in the
            light and with the looks of new scenes.
        track: Watches the work.

    Raises:
        Unsatisfiable: A task can't be made of these objects; the message says what is missing.
        BadData: The folder beside the file belongs to another suite, or the file's name looks like
            a packaged suite's.
    """
    table = setup or ROOM_TABLE
    path = Path(out)
    check_new_name(path.stem, path)
    folder, library = BuildFolder(path.with_suffix(".parts")), open_library(pool)
    places = places_of(counts, first)
    rules, audit = rules_for(library), what_is_wrong if certified else None
    salt = begin(folder, pool, public=public, unchecked=not certified, setup=table, rules=rules)
    with Renderer(engine=table.renderer) as renderer:
        resources = BuildResources(library, tables_for(pool), renderer, audit, salt, table, rules)
        waiting: Sequence[TaskSlot] = places
        while waiting:
            for place in track(waiting, "Building"):
                for _ in fill(place, folder, resources):
                    pass
            waiting = turned_back(folder, places)
    assemble(path, folder, places, library, salt)
    return load_suite(path)
