"""`probe assets annotate | review`: let a model say what objects are, and correct it by hand."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from pathlib import Path
from typing import Annotated

import tyro

from probe.api.models import model_behind
from probe.api.resources import Pool, library, library_folder
from probe.assets.annotation.applying import apply_notes
from probe.assets.annotation.notes import (
    Note,
    from_source,
    note_path,
    read_note,
    read_notes,
    said,
    write_note,
)
from probe.assets.annotation.table import TABLE, corrected, write_table
from probe.assets.annotation.words import describe
from probe.assets.library import Library
from probe.assets.spec import ObjectSpec
from probe.cli.address import check_address
from probe.cli.assets_review import draw_own, kept_views, with_own, with_twins
from probe.cli.numbers import check_numbers
from probe.cli.screen import say, track
from probe.errors import ModelFailed
from probe.render.portraits import GROUND
from probe.render.renderer import Renderer
from probe.report.review import write_review
from probe.types import Array, Ask

PAGE = "review.html"
_LOADED = 12


def annotate(
    out: Annotated[Path, tyro.conf.Positional],
    endpoint: str,
    model: str,
    pool: Pool = "own",
    limit: int | None = None,
    timeout: float = 120.0,
) -> None:
    """Show a model each object from six sides and note what it says of it.

    May be interrupted and run again: objects that a model or a person has described already are
    skipped; those without a usable reply are asked about again.

    Args:
        out: Folder for notes and pictures.
        endpoint: A server that speaks OpenAI's protocol ("http://localhost:8000/v1"); its key is
            in OPENAI_API_KEY.
        model: As the server calls it.
        pool: Which objects; scans need PROBE_ASSETS.
        limit: At most this many of them.
        timeout: Seconds to wait for a reply before trying again.
    """
    check_numbers({"--limit": limit, "--timeout": timeout})
    check_address(endpoint)
    objects, ask = library(pool), model_behind(endpoint, model, timeout)
    waiting = [spec for spec in objects.specs[:limit] if not _is_done(out, spec)]
    with Renderer() as renderer:
        for start in range(0, len(waiting), _LOADED):
            some = waiting[start : start + _LOADED]
            renderer.load({spec.id: objects.body(spec.id).mesh for spec in some}, GROUND)
            for spec in track(some, f"Objects {start + 1} to {start + len(some)}"):
                write_note(
                    out, _noted(out, spec, kept_views(out, spec.id, spec.size, renderer), ask)
                )
    _tell(out, objects, limit)
    _carry_over(read_notes(out))


def review(out: Annotated[Path, tyro.conf.Positional]) -> None:
    """Write a table and a page of your objects, after reading your corrections of the table.

    Needs no model: the first time, it takes the words from the files of your objects and draws
    them. Edit review.csv beside review.html with any program, then run this again: what you
    changed is marked as human, and no model overrules it.

    Args:
        out: Folder for table, page and pictures; `probe assets annotate` may have written to it.
    """
    notes = read_notes(out)
    table = out / TABLE
    if table.exists():
        before, notes = notes, corrected(table, notes)
        changed = [new for new, old in zip(notes, before, strict=True) if new != old]
        _carry_over(notes)
        for note in changed:
            write_note(out, note)
        say(f"{len(changed)} objects corrected.")
    else:
        _carry_over(notes)
    own = not notes or any(note.id.startswith("own_") for note in notes)
    crowd = library("procedural").specs if own else ()
    notes = with_twins(with_own(out, notes) if own else notes, [spec.name for spec in crowd])
    write_table(table, notes)
    write_review(out / PAGE, notes)
    if own and draw_own(out):
        write_review(out / PAGE, notes)
    say(f"{len(notes)} objects: correct {table} beside {out / PAGE}, then run this again.")


def _carry_over(notes: Sequence[Note]) -> None:
    """Your own objects are called so from now on."""
    if changed := apply_notes(library_folder(), notes):
        say(f"{changed} objects of {library_folder()} are as you said now.")


def _is_done(out: Path, spec: ObjectSpec) -> bool:
    path = note_path(out, spec.id)
    return path.exists() and read_note(path).done


def _noted(out: Path, spec: ObjectSpec, views: list[Array], ask: Ask) -> Note:
    path = note_path(out, spec.id)
    note = read_note(path) if path.exists() else from_source(spec)
    try:
        return said(note, describe(views, ask), "model")
    except ModelFailed as failure:
        return note.model_copy(update={"problem": str(failure)[:500]})


def _tell(out: Path, objects: Library, limit: int | None) -> None:
    wanted = {spec.id for spec in objects.specs[:limit]}
    notes = [note for note in read_notes(out) if note.id in wanted]
    counts = Counter("described" if note.done else "without a usable reply" for note in notes)
    said_so = ", ".join(f"{count} {what}" for what, count in counts.items()) or "none"
    say(f"{len(wanted)} objects: {said_so}. Notes are in {out / 'notes'}.")
    for note in notes:
        if note.problem:
            say(f"  {note.id}: {note.problem}")
    if counts["without a usable reply"]:
        say("Run it again to ask about those.")
    say(f"`probe assets review {out}` makes a table of them to correct.")
