"""Folders of assets for nodes that don't see the driver's disk: by content, once a node."""

from __future__ import annotations

import hashlib
import json
import shutil
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from probe.engines.result_store import ResultStore
from probe.errors import BadData
from probe.files import alone, whole_folder, write_bytes


@dataclass(frozen=True)
class AssetBundle:
    """A folder, file by file.

    Attributes:
        store: Holds each file under its SHA-256.
        files: SHA-256 of each file, by its path within the folder.
    """

    store: ResultStore
    files: Mapping[str, str]

    @property
    def digest(self) -> str:
        """SHA-256 of all names and contents."""
        return hashlib.sha256(json.dumps(dict(self.files), sort_keys=True).encode()).hexdigest()

    def fetch(self, cache: Path) -> Path:
        """The folder on this machine; what isn't there yet is fetched, by one process at a time.

        Raises:
            BadData: A file is missing in the store, or isn't what it was.
            OutputFailed: The disk is full.
        """
        folder = cache / "nodes" / self.digest
        with alone(folder.parent):
            if not folder.exists():
                for half in folder.parent.glob(f".{folder.name}.*"):
                    shutil.rmtree(half, ignore_errors=True)
                with whole_folder(folder) as building:
                    for name, sha in self.files.items():
                        write_bytes(building / name, self._fetched(sha))
        return folder

    def _fetched(self, sha: str) -> bytes:
        content = self.store.read(sha)
        if hashlib.sha256(content).hexdigest() != sha:
            raise BadData(
                f"{self.store.url}/{sha}", "has been changed", "Delete it and start again"
            )
        return content


def publish(folder: Path, store: ResultStore) -> AssetBundle:
    """Put a folder's files into a store, those that it lacks.

    Raises:
        BadData: The store can't be read.
        OutputFailed: It can't be written.
    """
    there, files = store.names(), dict[str, str]()
    for path in sorted(path for path in folder.rglob("*") if path.is_file()):
        content = path.read_bytes()
        sha = hashlib.sha256(content).hexdigest()
        files[path.relative_to(folder).as_posix()] = sha
        if sha not in there:
            store.write(sha, content)
    return AssetBundle(store, files)
