"""`probe export`: a suite as a data set for other programs."""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path

from probe.api.resources import cache_folder
from probe.assets.library import Library
from probe.bench.dataset import CARD, TABLE, Row, row_of, write_dataset
from probe.cli.metavars import Folder, SuiteName
from probe.cli.objects import all_objects, check
from probe.cli.screen import say, track
from probe.episodes.conditions import Conditions, RendererKind
from probe.episodes.participation import Points
from probe.errors import BadData
from probe.render.renderers import Renderers
from probe.runs.stills import stills
from probe.runs.viewpoints import renderer_of, viewpoint_of
from probe.tasks.suite import Suite
from probe.tasks.suite_file import find_suite
from probe.transcripts.pictures import jpeg


def export(
    suite: SuiteName,
    out: Folder,
    points: Points = "pixels",
    renderer: RendererKind = "own",
) -> None:
    """Write a suite's pictures, questions and answers as a data set of Hugging Face's form.

    Args:
        suite: "v2", "v1", "demo" or a file that `probe suite build` wrote.
        out: A new folder; `datasets.load_dataset` reads it.
        points: How coordinates are written in the texts.
        renderer: What draws the pictures: as the suite was frozen, or another; the card says which.
            blender needs the extra of that name, and more time.
    """
    _check_place(out)
    asked, things = find_suite(suite), all_objects()
    check(asked, things)
    conditions = Conditions(renderer=renderer)
    rows = _rows(asked, things, points, conditions)
    drawn_by = {renderer_of(task, conditions) for task in asked.tasks}
    count = write_dataset(out, asked.name, rows, asked.objects, drawn_by)
    say(f"{count} tasks are in {out}; the answers too, so keep its canary with every copy.")


def _check_place(out: Path) -> None:
    """See that nothing is there but what an export leaves that was broken off: a table, no card.

    Raises:
        BadData: Something is.
    """
    remedy = "Choose a new folder"
    if (out / CARD).exists():
        raise BadData(out, f"has a {CARD} already", remedy)
    if os.path.lexists(out) and not out.is_dir():
        raise BadData(out, "is there already, and no folder", remedy)
    parts = {out / TABLE, *(out / TABLE).parents}
    strange = [] if not out.exists() else [it for it in out.rglob("*") if it not in parts]
    if strange:
        reason = f"holds something else already ({strange[0].relative_to(out)})"
        raise BadData(out, reason, remedy)


def _rows(suite: Suite, things: Library, points: Points, conditions: Conditions) -> Iterator[Row]:
    with Renderers(cache_folder() / "light") as renderers:
        for task in track(suite.tasks, "Drawing"):
            viewpoint = viewpoint_of(task, conditions, things.assets)
            renderer = renderers[viewpoint.renderer]
            (picture,) = stills("direct", task, viewpoint, things, renderer)
            yield row_of(task, jpeg(picture), points)
