"""Reads files from outside: regular ones, no larger than they may be. Knows no format."""

from __future__ import annotations

import errno
import os
import stat
from pathlib import Path
from typing import BinaryIO

MIB = 2**20
DOCUMENT = 64 * MIB
"""Bytes of a file that people write or correct, or that describes one thing."""

SUITE = 1024 * MIB
"""Of a suite; one of 20,000 tasks has about 250 MB."""

RECORDS = 4096 * MIB
"""Of a file of records; an episode has 5 to 150 kB."""

MESH = 1024 * MIB
"""Of a file with an object's triangles or pictures."""

VALUES = 50_000_000
"""Numbers, texts, lists and objects in a JSON file: what they take in memory is many times what
they take on disk. A suite of 20,000 tasks has about 16 million."""


def opened(path: Path) -> BinaryIO:
    """A file to read from; a pipe, a device or a folder in its place would be waited for for ever.

    Raises:
        OSError: It can't be read, or is no regular file.
    """
    handle = os.open(path, os.O_RDONLY | os.O_NONBLOCK | os.O_CLOEXEC)
    mode = os.fstat(handle).st_mode
    if not stat.S_ISREG(mode):
        os.close(handle)
        is_folder = stat.S_ISDIR(mode)
        reason = "is a folder, not a file" if is_folder else "is no regular file"
        raise OSError(errno.EISDIR if is_folder else errno.EINVAL, reason)
    return os.fdopen(handle, "rb")


def is_there(path: Path) -> bool:
    """Whether anything is at a path, a link to nowhere included.

    Where a missing file stands for "nothing was said", one that can't be found any more mustn't.
    """
    return os.path.lexists(path)


def contents(path: Path, most: int = DOCUMENT) -> bytes:
    """All bytes of a file.

    Args:
        path: The file.
        most: Bytes that it may have.

    Raises:
        OSError: It can't be read, is no regular file, or is too large.
    """
    with opened(path) as file:
        if os.fstat(file.fileno()).st_size > most:
            reason = f"is larger than the {most / MIB:,.0f} MB that are read of it"
            raise OSError(errno.EFBIG, reason)
        return file.read()


def words(path: Path, most: int = DOCUMENT, encoding: str = "utf-8") -> str:
    """All of a text file; see contents().

    Raises:
        OSError: As contents().
        UnicodeDecodeError: It is no text in that encoding.
    """
    return contents(path, most).decode(encoding).replace("\r\n", "\n")


def json_contents(path: Path, most: int = DOCUMENT) -> bytes:
    """All bytes of a JSON file, unless it holds more values than fit into memory.

    Raises:
        OSError: As contents(), or there are too many.
    """
    content = contents(path, most)
    values = sum(content.count(mark) for mark in (b",", b"[", b"{"))
    if values > VALUES:
        reason = f"holds about {values:,} values, and at most {VALUES:,} are read"
        raise OSError(errno.EFBIG, reason)
    return content
