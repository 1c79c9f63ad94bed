"""Unpack a ZIP into a folder of its own: whole or not there, nothing outside it."""

from __future__ import annotations

import shutil
import stat
import zipfile
import zlib
from pathlib import Path, PurePosixPath

from probe.errors import BadData, OutputFailed
from probe.files import whole_folder

MAX_BYTES = 20 * 2**30
MAX_FILES = 100_000
MAX_RATIO = 200
_AGAIN = "Download it again."


def unpack(archive: Path, folder: Path) -> None:
    """Unpack a ZIP; what the folder held before is replaced.

    Raises:
        BadData: It is damaged, leads outside the folder, holds links, or would grow enormous.
        OutputFailed: The disk is full, or the folder can't be written.
    """
    try:
        with zipfile.ZipFile(archive) as file:
            _check(archive, file.infolist())
            with whole_folder(folder) as building:
                file.extractall(building)
                if folder.exists():
                    shutil.rmtree(folder)
    except (zipfile.BadZipFile, zlib.error, EOFError, NotImplementedError, RuntimeError) as error:
        raise BadData(archive, f"is no whole ZIP file ({error})", _AGAIN) from error
    except OSError as error:
        raise OutputFailed(folder, error) from error


def _check(archive: Path, entries: list[zipfile.ZipInfo]) -> None:
    if len(entries) > MAX_FILES:
        raise BadData(archive, f"holds {len(entries):,} files", _AGAIN)
    for entry in entries:
        name = PurePosixPath(entry.filename.replace("\\", "/"))
        if name.is_absolute() or ".." in name.parts or ":" in entry.filename[:2]:
            raise BadData(archive, f"leads outside its folder ({entry.filename[:80]!r})", _AGAIN)
        if stat.S_ISLNK(entry.external_attr >> 16):
            raise BadData(archive, f"holds a link ({entry.filename[:80]!r})", _AGAIN)
    size = sum(entry.file_size for entry in entries)
    packed = sum(entry.compress_size for entry in entries)
    if size > MAX_BYTES or (size > 2**30 and size > MAX_RATIO * packed):
        raise BadData(archive, f"would grow to {size / 2**30:.1f} GB", _AGAIN)
