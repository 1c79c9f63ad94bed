"""The page that comes with a data set: how many, of what, under which licences."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Mapping, Sequence
from importlib.resources import files

from probe.assets.spec import ObjectSpec
from probe.scene.setup import UR5_TABLE
from probe.train.choose.chosen import LoadedSelection
from probe.train.dataset.manifest import (
    Manifest,
    augmented_told,
    objects_told,
    words_told,
)

_PLACES = {"pixels": "in pixels of a picture 1024 wide and high", "0-1000": "in thousandths"}


def card(
    name: str, manifest: Manifest, chosen: LoadedSelection, specs: Mapping[str, ObjectSpec]
) -> str:
    """The page, as Markdown.

    Args:
        name: Of the data set.
        manifest: What it holds.
        chosen: What it was made of.
        specs: What the catalogue says of the objects that are shown, by id.
    """
    words = (files("probe.train") / "data/card.md").read_text("utf-8")
    for folder in ("llamafactory/", "vila/", "images/"):
        if not any(file.startswith(folder) for file in manifest.files):
            words = _without(words, f"| `{folder}`")
    if not manifest.augmented:
        words = _without(words, "- **Augmented**")
    if not (said := words_told(manifest)):
        words = _without(words, "- **Retold**")
    document = chosen.document
    return words.format(
        name=name,
        total=manifest.total,
        counts=_counts(manifest.examples),
        pictures=_pictures(manifest, chosen),
        points=_PLACES[manifest.points],
        teachers=", ".join(sorted({record.agent for _, record in chosen.episodes})),
        sources=", ".join(document.sources),
        suites=", ".join(document.suites),
        refused=len(document.refused),
        limits=", ".join(
            f"{question_type} {most}" for question_type, most in sorted(document.limits.items())
        ),
        objects=objects_told(manifest.objects),
        augmented=augmented_told(manifest),
        retold=said,
        licences=_licences(shown_in(chosen), specs),
    )


def _pictures(manifest: Manifest, chosen: LoadedSelection) -> str:
    """How many are shown, how large, and what drew them; or in which setting there are none."""
    if not manifest.pictures:
        settings = {setting for some in manifest.examples.values() for setting in some}
        return f"none are shown; the setting is {' and '.join(sorted(settings))}"
    side, whole = manifest.side_px, UR5_TABLE.picture_px
    shrunk = "" if side == whole else f", made smaller from {whole} x {whole}"
    drawn_by = sorted({record.viewpoint.renderer for _, record in chosen.episodes})
    size = f"JPEG, {side} x {side}{shrunk}, drawn by {' and '.join(drawn_by)}"
    return f"{manifest.pictures:,} are shown, {size}"


def _without(words: str, start: str) -> str:
    lines = words.splitlines(keepends=True)
    return "".join(line for line in lines if not line.startswith(start))


def _counts(examples: Mapping[str, Mapping[str, int]]) -> str:
    rows = [
        f"| {question_type} | {sum(settings.values()) - settings.get('direct', 0)} "
        f"| {settings.get('direct', 0)} |"
        for question_type, settings in sorted(examples.items())
    ]
    return "\n".join(rows)


def shown_in(chosen: LoadedSelection) -> set[str]:
    """The objects on the tables of what was chosen."""
    return {it.object_id for task in chosen.suite.tasks for it in task.scene.objects}


def _licences(shown: Iterable[str], specs: Mapping[str, ObjectSpec]) -> str:
    by_source: defaultdict[tuple[str, str], int] = defaultdict(int)
    for id in shown:
        by_source[specs[id].licence, specs[id].source] += 1
    rows: Sequence[str] = [
        f"| {licence} | {source} | {count} |"
        for (licence, source), count in sorted(by_source.items())
    ]
    return "\n".join(["| licence | source | objects |", "|---|---|---|", *rows])
