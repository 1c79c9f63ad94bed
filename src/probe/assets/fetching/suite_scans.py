"""Fetch the scans of the catalogue, and keep only those that a suite was made with."""

from __future__ import annotations

import csv
import hashlib
import io
import shutil
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from probe.assets.cache import Cache
from probe.assets.fetching.download import Progress, download
from probe.assets.fetching.scan_glb import scan_glb
from probe.assets.fetching.scan_manifest import ScanFile, ScanSource
from probe.assets.fetching.unpack import unpack
from probe.assets.folders import UNFINISHED
from probe.assets.mesh.fingerprint import Fingerprint, fingerprint, same
from probe.assets.pools.scan_catalogue import scan_sources
from probe.assets.pools.scans import scan_body
from probe.errors import BadData, BadMesh, DownloadFailed, ProbeError
from probe.files import write_bytes, write_text
from probe.reading import words

_INDEX = ("id", "source_dataset", "licence")
_REMEDY = (
    "Take its file as <id>.glb from someone who has it (--mirror ADDRESS), "
    "or from the folder that PROBE_ASSETS names where the suite is in use."
)


@dataclass(frozen=True)
class ScanFetching:
    """Where scans come from and go.

    Attributes:
        folder: The folder of scans; gets ``<id>.glb`` and ``index.csv``.
        sources: Collections by name.
        prints: What a suite says its objects are, by id; others aren't compared.
        cache: Keeps the bodies that are computed for the comparison.
        mirror: Address of a folder with ``<id>.glb``, instead of the public sources.
    """

    folder: Path
    sources: Mapping[str, ScanSource]
    prints: Mapping[str, Fingerprint]
    cache: Cache
    mirror: str | None = None

    def path(self, scan: ScanFile) -> Path:
        return self.folder / f"{scan.id}.glb"

    def is_there(self, scan: ScanFile) -> bool:
        """Whether the right scan lies in the folder already."""
        try:
            return self.path(scan).is_file() and self._is_right(scan, self.folder)
        except BadMesh:
            return False

    def fetch(self, scan: ScanFile, progress: Progress) -> None:
        """Download one scan, make its GLB, and keep it if it is the suite's.

        Raises:
            DownloadFailed: A file can't be had, or isn't what the mirror has to serve.
            BadMesh: The files can't be used.
            BadData: An archive is damaged, or the object is another than the suite's.
            OutputFailed: The disk is full, or the folder can't be written.
        """
        if self.mirror is not None:
            url = f"{self.mirror.rstrip('/')}/{scan.id}.glb"
            download(url, self.path(scan), scan.sha256, progress)
            return
        work = self.folder / UNFINISHED / scan.id
        source = self.sources[scan.source]
        files = work / "files"
        for name, url in source.urls_of(scan.item).items():
            path = (work if name.endswith(".zip") else files) / name
            download(url, path, None, progress)
            if path.suffix == ".zip":
                unpack(path, files)
        made = work / "made"
        try:
            write_bytes(made / f"{scan.id}.glb", scan_glb(scan, source.layout, files))
            self._check(scan, made)
            (made / f"{scan.id}.glb").replace(self.path(scan))
        finally:
            # What was wrong would be wrong again; what was right is made.
            shutil.rmtree(work, ignore_errors=True)

    def _check(self, scan: ScanFile, made: Path) -> None:
        if not self._is_right(scan, made):
            reason = f"what {self.sources[scan.source].about} has of {scan.item} is another object"
            raise BadData(scan.id, f"{reason} than the one in v1-scans", _REMEDY)

    def _is_right(self, scan: ScanFile, folder: Path) -> bool:
        content = (folder / f"{scan.id}.glb").read_bytes()
        if hashlib.sha256(content).hexdigest() == scan.sha256 or scan.id not in self.prints:
            return True
        found = fingerprint(scan_body(scan.id, folder, self.cache))
        return same(found, self.prints[scan.id])


def fetch_all(
    scans: Sequence[ScanFile],
    fetching: ScanFetching,
    progress: Callable[[ScanFile], Progress],
    failed: Callable[[ScanFile, ProbeError], None],
) -> None:
    """Fetch those that aren't there, one after another, and write what is known of them.

    Args:
        scans: Which.
        fetching: Where from and where to.
        progress: Gives what is told of the download of a scan.
        failed: Told of each that failed; the others go on.

    Raises:
        BadData: Some failed.
        OutputFailed: The disk is full, or the folder can't be written.
    """
    (fetching.folder / UNFINISHED).mkdir(parents=True, exist_ok=True)
    write_index(scans, fetching.folder)
    missing: list[str] = []
    for scan in scans:
        told = progress(scan)
        try:
            if not fetching.is_there(scan):
                fetching.fetch(scan, told)
        except (DownloadFailed, BadMesh, BadData) as error:
            missing.append(scan.id)
            failed(scan, error)
    if missing:
        reason = f"{len(missing)} of {len(scans)} scans are missing: {', '.join(missing)}"
        remedy = "Run it again to go on; what stays missing says above what would help"
        raise BadData(fetching.folder, reason, f"{remedy}.")
    shutil.rmtree(fetching.folder / UNFINISHED, ignore_errors=True)


def write_index(scans: Sequence[ScanFile], folder: Path) -> None:
    """Write licence and source of each scan into the folder's table; lines that are there stay.

    Raises:
        BadData: The table that is there can't be read.
        OutputFailed: The folder can't be written.
    """
    path = folder / "index.csv"
    known = scan_sources(folder) if path.is_file() else {}
    new = [scan for scan in scans if scan.id not in known]
    if not new:
        return
    text = words(path) if known else ",".join(_INDEX) + "\n"
    columns = next(csv.reader([text.splitlines()[0]]))
    added = io.StringIO()
    table = csv.DictWriter(added, columns, restval="", extrasaction="ignore", lineterminator="\n")
    table.writerows(scan.model_dump() for scan in new)
    write_text(path, text.rstrip("\n") + "\n" + added.getvalue())
