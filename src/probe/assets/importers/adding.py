"""Add many objects to a user's library: in parallel, and again from where it stopped."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass
from itertools import chain, count
from pathlib import Path
from typing import Literal

from probe.assets.cache import Cache
from probe.assets.gltf.glb import glb_bytes
from probe.assets.importers import IMPORTERS
from probe.assets.importers.entries import object_id, remarks_on
from probe.assets.importers.limits import limited
from probe.assets.importers.normalised import content_of, normalised
from probe.assets.importers.options import ImportOptions
from probe.assets.importers.parallel import spread
from probe.assets.importers.selection import Passed, sift
from probe.assets.importers.source import Source
from probe.assets.pools.own import own_body, own_entries, remove_object, store_object
from probe.errors import BadData, BadMesh

Status = Literal["added", "skipped", "refused"]


@dataclass(frozen=True)
class ImportOutcome:
    """What became of one object.

    Attributes:
        label: Its place in the folder that was added.
        status: Added, there already, or refused.
        detail: Its id in the library, or why it was refused.
        remarks: What its user should know of it.
    """

    label: str
    status: Status
    detail: str
    remarks: tuple[str, ...] = ()


@dataclass(frozen=True)
class ImportTarget:
    """Where objects go: a library's folder, and the cache for their bodies."""

    library: Path
    cache: Path


@dataclass(frozen=True)
class _Job:
    source: Source
    object_id: str
    order: ImportOptions
    target: ImportTarget


def find_sources(path: Path, order: ImportOptions) -> list[Source]:
    """What there is to add below a folder, in a fixed order.

    Raises:
        BadData: There is nothing of this format.
    """
    if not path.exists():
        raise BadData(path, "is not there", "Name a folder or file of objects.")
    found = IMPORTERS[order.format].find(path)
    if not found:
        remedy = "Name a folder that holds some; docs/how-to/import shows each format's layout."
        raise BadData(path, f"holds no objects of the format {order.format}", remedy)
    return found


def objects_at(path: Path, order: ImportOptions) -> tuple[list[Source], list[Passed]]:
    """What there is to add below a folder, and what is passed over and why.

    Raises:
        BadData: There is nothing of this format.
    """
    kept, passed = sift([(source, order) for source in find_sources(path, order)])
    return [source for source, _ in kept], passed


def add(
    sources: Sequence[Source], order: ImportOptions, target: ImportTarget, workers: int
) -> Iterator[ImportOutcome]:
    """Add objects, each wholly or not at all; yields what became of each as it is known.

    What is there already, by the content of its files, is skipped: an interrupted run goes on
    where it stopped. Ids are given in the order of the labels.

    Raises:
        OutputFailed: The library or the cache can't be written.
        BadData: The library is broken.
    """
    there = {entry.content: entry.id for entry in own_entries(target.library)}
    taken = set(there.values())
    jobs: list[_Job] = []
    for source in sorted(sources, key=lambda source: source.label):
        try:
            content, name = content_of(source, order), IMPORTERS[order.format].facts(source).name
        except (BadMesh, BadData) as refusal:
            yield ImportOutcome(source.label, "refused", str(refusal))
            continue
        if content in there:
            yield ImportOutcome(source.label, "skipped", there[content])
            continue
        own_id = _free_id(object_id(name), taken)
        taken.add(own_id)
        there[content] = own_id
        jobs.append(_Job(source, own_id, order, target))
    for job, outcome in spread(_add, jobs, workers):
        yield outcome or _lost(job)


def _free_id(wanted: str, taken: Collection[str]) -> str:
    """The id itself, or with the first number from 2 on that isn't taken."""
    numbered = (f"{wanted}_{number}" for number in count(2))
    return next(own_id for own_id in chain([wanted], numbered) if own_id not in taken)


def _add(job: _Job) -> ImportOutcome:
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
        return ImportOutcome(job.source.label, "refused", str(refusal))
    return ImportOutcome(job.source.label, "added", job.object_id, remarks_on(entry))


def _lost(job: _Job) -> ImportOutcome:
    reason = "a worker process died over this or another object; run again to go on"
    return ImportOutcome(job.source.label, "refused", f"{job.source.mesh}: {reason}.")
