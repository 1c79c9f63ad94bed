"""Results of units on their way from the nodes of a cluster: one file each, whole or not there."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from contextlib import suppress
from dataclasses import dataclass
from functools import cached_property
from importlib import import_module
from pathlib import Path
from typing import Any

from probe.errors import BadData, MissingExtra, OutputFailed
from probe.files import write_bytes

_REMEDY = "See that the address is right, and that every node has credentials for it"


@dataclass(frozen=True)
class ResultStore:
    """A folder that all nodes see, or a prefix in an object store.

    Attributes:
        url: A path ("file://" may stand before it), or an address that fsspec knows ("s3://bucket/run").
    """

    url: str

    @property
    def folder(self) -> Path | None:
        """The folder; None for an object store."""
        path = self.url.removeprefix("file://")
        return None if "://" in path else Path(path)

    def under(self, name: str) -> ResultStore:
        """A store within this one."""
        return ResultStore(f"{self.url.rstrip('/')}/{name}")

    def write(self, key: str, content: bytes) -> None:
        """Write a whole file or none.

        Raises:
            OutputFailed: It can't be written.
        """
        if self.folder is not None:
            write_bytes(self.folder / key, content)
            return
        try:
            self._objects.pipe_file(f"{self.url}/{key}", content)
        except Exception as error:  # each kind of store has errors of its own
            raise OutputFailed(f"{self.url}/{key}", f"{error}. {_REMEDY}") from error

    def read(self, key: str) -> bytes:
        """The content of a file.

        Raises:
            BadData: It isn't there, or can't be read.
        """
        try:
            if self.folder is not None:
                return (self.folder / key).read_bytes()
            content: bytes = self._objects.cat_file(f"{self.url}/{key}")
        except Exception as error:
            raise BadData(f"{self.url}/{key}", str(error), _REMEDY) from error
        return content

    def read_all(self, keys: Sequence[str]) -> dict[str, bytes]:
        """The contents of files, fetched at the same time; in the order of the keys.

        Raises:
            BadData: One isn't there, or can't be read.
        """
        if self.folder is not None or not keys:
            return {key: self.read(key) for key in keys}
        try:
            found: dict[str, bytes] = self._objects.cat([f"{self.url}/{key}" for key in keys])
        except Exception as error:
            raise BadData(self.url, str(error), _REMEDY) from error
        content = {name.rpartition("/")[2]: whole for name, whole in found.items()}
        return {key: content[key] for key in keys}

    def names(self) -> set[str]:
        """What whole files are there.

        Raises:
            BadData: The store can't be read.
        """
        if self.folder is not None:
            files = self.folder.glob("[!.]*") if self.folder.exists() else ()
            return {file.name for file in files if file.is_file()}
        try:
            found = self._objects.find(self.url, maxdepth=1)
        except Exception as error:
            raise BadData(self.url, str(error), _REMEDY) from error
        return {str(name).rpartition("/")[2] for name in found}

    def has(self, key: str) -> bool:
        """Whether a whole file of this name is there.

        Raises:
            BadData: The store can't be read.
        """
        if self.folder is not None:
            return (self.folder / key).exists()
        try:
            found: bool = self._objects.exists(f"{self.url}/{key}")
        except Exception as error:
            raise BadData(self.url, str(error), _REMEDY) from error
        return found

    def remove_all(self, keys: Collection[str]) -> None:
        """Remove files, if they are there."""
        if self.folder is not None:
            for key in keys:
                (self.folder / key).unlink(missing_ok=True)
        elif keys:
            with suppress(FileNotFoundError):
                self._objects.rm([f"{self.url}/{key}" for key in keys])

    def sweep(self, kept: Collection[str] = ()) -> None:
        """Remove all files but some, also those that a killed worker left half-written."""
        self.remove_all(self.names() - set(kept))
        if self.folder is not None and self.folder.exists():
            for half in self.folder.glob(".*"):
                half.unlink(missing_ok=True)
            if not any(self.folder.iterdir()):
                self.folder.rmdir()

    @cached_property
    def _objects(self) -> Any:
        try:
            fsspec = import_module("fsspec")
            return fsspec.core.url_to_fs(self.url, use_listings_cache=False)[0]
        except ImportError as error:
            raise MissingExtra("--store", "ray") from error
        except ValueError as error:
            raise BadData(self.url, str(error), 'Say a path, or "s3://bucket/prefix"') from error
