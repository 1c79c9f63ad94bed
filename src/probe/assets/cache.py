"""A folder of arrays named by what they were computed from. Knows not what they mean."""

from __future__ import annotations

import hashlib
import io
import logging
import zipfile
import zlib
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from probe import SUMS_BOUND
from probe.files import write_bytes
from probe.types import Array

logger = logging.getLogger(__name__)

DAMAGED = (OSError, ValueError, EOFError, KeyError, zipfile.BadZipFile, zlib.error)


def content_key(*parts: str | bytes) -> str:
    """A name for what is computed from these parts; 32 hex digits."""
    content = hashlib.blake2b(digest_size=16)
    for part in parts:
        raw = part.encode() if isinstance(part, str) else part
        content.update(len(raw).to_bytes(8, "big"))
        content.update(raw)
    return content.hexdigest()


@dataclass(frozen=True)
class Cache:
    """Arrays on disk; whoever stores them chooses a key that changes with their content."""

    folder: Path

    def load(self, key: str) -> dict[str, Array] | None:
        """The arrays stored under a key; None if there are none.

        A damaged entry is removed and counts as none: what it held can be computed again.
        """
        path = self.path(key)
        try:
            with np.load(io.BytesIO(path.read_bytes()), allow_pickle=False) as file:
                return {name: file[name] for name in file.files}
        except FileNotFoundError:
            return None
        except DAMAGED as error:
            logger.warning("Cache entry %s is damaged (%s); it is computed again.", path, error)
            path.unlink(missing_ok=True)
            return None

    def store(self, key: str, arrays: Mapping[str, Array]) -> None:
        """Keep arrays under a key; readers find all of them or nothing.

        Raises:
            OutputFailed: The disk is full, or the folder can't be written.
        """
        write_bytes(self.path(key), _packed(arrays))

    def path(self, key: str) -> Path:
        """The file of a key; another where this process's sums differ in their last bits.

        What lies in the folder itself is read by nobody: until both kinds were told apart, any
        process wrote there.
        """
        sums = "bound-sums" if SUMS_BOUND else "other-sums"
        return self.folder / sums / key[:2] / f"{key}.npz"


def _packed(arrays: Mapping[str, Array]) -> bytes:
    """What NumPy's own savez_compressed writes, in a quarter of its time and 5 % larger."""
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED, compresslevel=1) as file:
        for name, array in arrays.items():
            with file.open(f"{name}.npy", "w", force_zip64=True) as member:
                np.lib.format.write_array(member, np.asanyarray(array), allow_pickle=False)
    return buffer.getvalue()
