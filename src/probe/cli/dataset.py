"""`probe dataset`: a selection as a data set for trainers."""

from __future__ import annotations

import shutil
from collections import Counter
from collections.abc import Generator, Iterator
from contextlib import contextmanager
from dataclasses import replace
from itertools import chain
from typing import Literal

from probe.api.resources import Pool, opener
from probe.assets.cache import Cache
from probe.cli.metavars import Folder
from probe.cli.numbers import check_numbers
from probe.cli.objects import check
from probe.cli.screen import say, track
from probe.engines.local import LocalEngine
from probe.episodes.participation import Points
from probe.errors import BadData
from probe.files import check_new
from probe.scene.setup import UR5_TABLE
from probe.tasks.suite import check_known
from probe.train.choose.chosen import LoadedSelection, read_selection
from probe.train.dataset.augment.augmenting import Augmentation, augmented
from probe.train.dataset.augment.certain import NotCertain
from probe.train.dataset.augment.listed_ids import without_finding
from probe.train.dataset.augment.speech import AS_TAUGHT, Speech, said_otherwise
from probe.train.dataset.augment.teller import SHORT_ALONE, AugmentationWay
from probe.train.dataset.drawing import DrawingWorker, draw, pictures_of
from probe.train.dataset.examples import TrainingExample, example_of
from probe.train.dataset.folder import Form, write_dataset
from probe.train.dataset.manifest import augmented_told
from probe.train.dataset.text_only import as_text_only, no_pictures
from probe.transcripts.prompts import Graphs

_SMALLEST_PX = 32
_IN_TEXT = {
    "--graphs": "does nothing without --setting",
    "--no-find": "pictures that were drawn show what was found",
    "--plain": "the teacher's words beside pictures stay as they were",
    "--augment": "pictures can't be told again, only texts",
}
"""Why some options need the setting text-only."""


def dataset(
    selected: Folder,
    out: Folder,
    points: Points | None = None,
    side: int = UR5_TABLE.picture_px,
    name: str = "PROBE, a teacher's episodes",
    others: bool = True,
    setting: Literal["text-only"] | None = None,
    graphs: Graphs | None = None,
    find: bool = True,
    plain: bool = False,
    augment: list[AugmentationWay] | None = None,
    balance: bool = False,
    seed: int = 0,
    pool: Pool = "procedural-2",
    workers: int = 2,
) -> None:
    """Draw the pictures of chosen episodes and write all of it down for TRL, LLaMA-Factory, VILA.

    Pictures that are drawn are kept beside the new folder until it is whole, so that a run that was
    stopped goes on.

    Args:
        selected: A folder that `probe select` wrote.
        out: A new folder.
        points: How coordinates are written in the texts; by default as the teacher did.
        side: Width and height of the pictures; what models are sent has 1024.
        name: For the card.
        others: Write LLaMA-Factory's and VILA's forms too.
        setting: Tell the episodes as a student sees them in this setting; by default as the
            teacher did. In text-only there are no pictures.
        graphs: How lists are told in the setting text-only; by default in full.
        find: Tell what the scripted teacher looked for by find_object. If not, grasps and pushes
            take their object_ids from the lists, about a quarter of all calls is left out, and
            the teacher's words are others. Can be left out in the setting text-only alone.
        plain: Have the scripted teacher say each thing in one way alone, so that a small model
            needn't learn which of several ways comes next. In the setting text-only alone.
        augment: Tell each episode once more in each of these ways, where that is certain: mirrored
            left to right, with its question in another wording, with other phrases of the scripted
            teacher, with its options or marks under other letters, with other names of all things,
            with other object_ids, with other colours (Compare alone), with other sizes of the two
            marked things (Size alone), without some things that nobody speaks of, or with a call
            that is refused, as its object_id is out of date. Such examples are marked and counted
            apart. In the setting text-only alone; by default nothing is told again.
        balance: Tell episodes of rare types up to four times in each of these ways, each time
            otherwise (mirrored once), the rarer the oftener.
        seed: Chooses the wordings, phrases, letters, names and so on of --augment.
        pool: Where the objects are that appear; all built-in ones by default.
        workers: Processes that draw.
    """
    check_new(out)
    check_numbers({"--workers": workers})
    speech = Speech(find, plain)
    _check(side, setting, graphs, augment, speech)
    if balance and not augment:
        raise BadData("--balance", "does nothing without --augment", "Say --augment, too")
    chosen = _in_setting(read_selection(selected), setting, graphs, speech)
    again = augmented(chosen.episodes, augment or [], seed, speech, balanced=balance)
    chosen = chosen if find else _without_finding(chosen)
    opened = opener(pool)
    things = opened()
    kept = out.with_name(f"{out.name}.pictures")
    worker = DrawingWorker(chosen.suite, opened, Cache(kept), side)
    if setting is not None:
        check_known(chosen.suite, things)
    else:
        check(chosen.suite, things)
        drawn = draw(worker, chosen.episodes, LocalEngine(workers))
        for _ in track(drawn, "Drawing", total=len(chosen.episodes)):
            pass
    counting = points or _points_of(chosen)
    specs = {spec.id: spec for spec in things.specs}
    form = Form(name, counting, side, others, speech)
    examples = _examples(chosen, worker if setting is None else None, counting)
    told_again = _told_again(again, counting)
    manifest = write_dataset(out, chain(examples, told_again), chosen, form, specs, again)
    shutil.rmtree(kept, ignore_errors=True)
    say(
        f"{manifest.total} examples with {manifest.pictures} pictures are in {out}; "
        f"its README.md says what they are."
    )
    if manifest.augmented:
        say(augmented_told(manifest))


def _in_setting(
    chosen: LoadedSelection, setting: str | None, graphs: Graphs | None, speech: Speech
) -> LoadedSelection:
    """The episodes in a student's setting and in the words of one; all calls are there still."""
    if setting is not None:
        chosen = as_text_only(chosen, graphs or "full")
    if speech == AS_TAUGHT:
        return chosen
    with _no_doubt("--plain" if speech.find else "--no-find"):
        return said_otherwise(chosen, speech)


def _without_finding(said: LoadedSelection) -> LoadedSelection:
    with _no_doubt("--no-find"):
        told = tuple((task, without_finding(record)) for task, record in said.episodes)
    return replace(said, episodes=told)


@contextmanager
def _no_doubt(option: str) -> Generator[None]:
    try:
        yield
    except NotCertain as doubt:
        remedy = f"Leave out {option}, or select without this episode"
        raise BadData(option, f"{doubt.task}: {doubt.reason}", remedy) from doubt


def _check(
    side: int,
    setting: str | None,
    graphs: Graphs | None,
    augment: list[AugmentationWay] | None,
    speech: Speech,
) -> None:
    """See that each option is in range and does something."""
    whole = UR5_TABLE.picture_px
    if not _SMALLEST_PX <= side <= whole:
        raise BadData("--side", f"{side} px", f"Say {_SMALLEST_PX} to {whole}")
    if setting is not None and side != whole:
        raise BadData("--side", f"does nothing with --setting {setting}", "Leave it out")
    asked = {
        "--graphs": graphs is not None,
        "--no-find": not speech.find,
        "--plain": speech.plain,
        "--augment": bool(augment),
    }
    for option in [it for it, is_asked in asked.items() if is_asked and setting is None]:
        raise BadData(option, _IN_TEXT[option], "Say --setting text-only, too, or leave it out")
    untold = [way for way in augment or [] if way in SHORT_ALONE and graphs != "short"]
    if untold:
        reason = "what full lists tell of the table's parts and of neighbours would no longer hold"
        raise BadData(f"--augment {' '.join(untold)}", reason, "Say --graphs short, too")
    if speech.plain and "phrases" in (augment or []):
        reason = "there are no other phrases with --plain"
        raise BadData("--augment phrases", reason, "Leave out one of them")


def _examples(
    chosen: LoadedSelection, worker: DrawingWorker | None, points: Points
) -> Iterator[TrainingExample]:
    """Examples with the pictures that a worker drew; without one there are none."""
    for task, record in track(chosen.episodes, "Writing"):
        shown = no_pictures(record) if worker is None else pictures_of(worker, record)
        yield example_of(task, record, shown, points)


def _told_again(again: Augmentation, points: Points) -> Iterator[TrainingExample]:
    """Examples of episodes that are told otherwise than they went, which have no pictures."""
    times = Counter[tuple[str, str, str, int]]()
    for way, task, record in again.episodes:
        times[telling := (way, task.id, record.agent, record.run)] += 1
        yield example_of(task, record, no_pictures(record), points, way, times[telling])


def _points_of(chosen: LoadedSelection) -> Points:
    """How the teachers counted, if all did so in the same way."""
    ways: set[Points] = {
        it.participation.points if it.participation else "pixels" for _, it in chosen.episodes
    }
    if len(ways) > 1:
        reason = f"places are counted in several ways: {', '.join(sorted(ways))}"
        raise BadData("--points", reason, "Say one of them")
    return ways.pop()
