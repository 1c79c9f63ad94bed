"""Add many objects to a user's library: in parallel, and again from where it stopped."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

from probe.assets.cache import Cache
from probe.assets.glb_writer import glb_bytes
from probe.assets.importers import IMPORTERS
from probe.assets.importers.entries import slug
from probe.assets.importers.limits import limited
from probe.assets.importers.normalised import content_of, normalised
from probe.assets.importers.order import Order
from probe.assets.importers.parallel import spread
from probe.assets.importers.source import Source
from probe.assets.own_pool import own_body, own_entries, remove_object, store_object
from probe.errors import BadData, BadMesh

Status = Literal["added", "skipped", "refused"]


@dataclass(frozen=True)
class Outcome:
    """What became of one object.

    Attributes:
        label: Its place in the folder that was added.
        status: Added, there already, or refused.
        detail: Its id in the library, or why it was refused.
    """

    label: str
    status: Status
    detail: str


@dataclass(frozen=True)
class Target:
    """Where objects go: a library's folder, and the cache for their bodies."""

    library: Path
    cache: Path


@dataclass(frozen=True)
class _Job:
    source: Source
    object_id: str
    order: Order
    target: Target


def find_sources(path: Path, order: Order) -> list[Source]:
    """What there is to add below a folder, in a fixed order.

    Raises:
        BadData: There is nothing of this format.
    """
    if not path.exists():
        raise BadData(path, "is not there", "Name a folder or file of objects.")
    found = IMPORTERS[order.format].find(path)
    if not found:
        remedy = "Name a folder that holds some; docs/extend/import shows each format's layout."
        raise BadData(path, f"holds no objects of the format {order.format}", remedy)
    return found


def add(sources: Sequence[Source], order: Order, target: Target, workers: int) -> Iterator[Outcome]:
    """Add objects, each wholly or not at all; yields what became of each as it is known.

    What is there already, by the content of its files, is skipped: an interrupted run goes on
    where it stopped.

    Raises:
        OutputFailed: The library or the cache can't be written.
        BadData: The library is broken.
    """
    there = {entry.content: entry.id for entry in own_entries(target.library)}
    taken = set(there.values())
    jobs: list[_Job] = []
    for source in sources:
        try:
            content, name = content_of(source, order), IMPORTERS[order.format].facts(source).name
        except (BadMesh, BadData) as refusal:
            yield Outcome(source.label, "refused", str(refusal))
            continue
        if content in there:
            yield Outcome(source.label, "skipped", there[content])
            continue
        object_id = slug(name) if slug(name) not in taken else f"{slug(name)}_{content[:6]}"
        taken.add(object_id)
        there[content] = object_id
        jobs.append(_Job(source, object_id, order, target))
    for job, outcome in spread(_add, jobs, workers):
        yield outcome or _lost(job)


def _add(job: _Job) -> Outcome:
    """Add one object and prepare its body; in a worker."""
    library, cache = job.target.library, Cache(job.target.cache / "bodies")
    try:
        with limited(job.source.mesh):
            mesh, entry = normalised(job.source, job.order)
            entry = entry.model_copy(update={"id": job.object_id})
            store_object(library, entry, glb_bytes(mesh, entry.licence))
            try:
                own_body(job.object_id, library, cache)
            except BaseException:
                remove_object(library, job.object_id)
                raise
    except (BadMesh, BadData) as refusal:
        return Outcome(job.source.label, "refused", str(refusal))
    return Outcome(job.source.label, "added", job.object_id)


def _lost(job: _Job) -> Outcome:
    reason = "a worker process died over this or another object; run again to go on"
    return Outcome(job.source.label, "refused", f"{job.source.mesh}: {reason}.")
