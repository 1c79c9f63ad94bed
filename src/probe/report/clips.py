"""Short films of manipulations that lie beside the pictures: what each is called, and which exist.

Knows nothing of how they are made.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Sequence
from pathlib import Path

from probe.episodes.record import EpisodeRecord
from probe.errors import BadData
from probe.files import write_bytes
from probe.reading import contents
from probe.scene.document import SceneDocument
from probe.toolshed.result import MOVING

CLIPS = "clips"
"""Folder of a run or a report that holds them."""

ENDINGS = (".webm", ".webp")


def clip_stem(record: EpisodeRecord, number: int) -> str:
    """The name of a manipulation's clip without its ending; it depends on all that moved.

    Whoever makes clips writes `clips/STEM.webm` (or .webp) into the folder of the records or of
    their report.

    Args:
        record: The episode.
        number: Of the step, from 1.
    """
    step = record.steps[number - 1]
    whose = [record.task, record.agent, record.run, *filter(None, [record.setting])]
    told = [
        [*whose, number, step.call.name, step.call.arguments],
        *(SceneDocument.of(scene).model_dump() for scene in record.scenes[number - 1 : number + 1]),
    ]
    return hashlib.sha256(json.dumps(told).encode()).hexdigest()[:20]


def collect_clips(
    record: EpisodeRecord, out: Path, kept: Sequence[Path] = ()
) -> tuple[tuple[int, str], ...]:
    """The clips of an episode that there are, by number of the step.

    Args:
        record: The episode.
        out: Folder of the report; what other folders hold is copied into its folder of clips.
        kept: Those other folders: of the runs.

    Returns:
        Numbers of steps, and addresses relative to the report.

    Raises:
        BadData: A clip can't be read.
        OutputFailed: It can't be written.
    """
    folders = [out / CLIPS, *(run / CLIPS for run in kept)]
    if not any(folder.is_dir() for folder in folders):
        return ()
    found: list[tuple[int, str]] = []
    for number, step in enumerate(record.steps, start=1):
        if step.call.name in MOVING and (path := _first(folders, clip_stem(record, number))):
            if path.parent != folders[0]:
                _take_over(path, folders[0] / path.name)
            found.append((number, f"{CLIPS}/{path.name}"))
    return tuple(found)


def _first(folders: Sequence[Path], stem: str) -> Path | None:
    paths = (folder / (stem + ending) for folder in folders for ending in ENDINGS)
    return next((path for path in paths if path.is_file()), None)


def _take_over(path: Path, to: Path) -> None:
    try:
        content = contents(path)
    except OSError as error:
        raise BadData(path, error.strerror or str(error), "Make the clip again") from error
    write_bytes(to, content)
