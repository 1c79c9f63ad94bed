"""Single bits flipped in files that are read back: none may be read as if it were whole."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
from verdict import Attack

from probe.errors import ProbeError


def flips(
    kind: str, path: Path, read: Callable[[Path], object], count: int, rng: np.random.Generator
) -> Iterator[Attack]:
    """Flip bits of a file, one at a time, and read it; the file is left as it was.

    Args:
        kind: What is attacked.
        path: The file.
        read: Reads it.
        count: How many bits, at places drawn evenly over the file.
        rng: Draws them.
    """
    whole = path.read_bytes()
    try:
        for place in rng.choice(8 * len(whole), size=count, replace=False):
            byte, bit = divmod(int(place), 8)
            changed = bytearray(whole)
            changed[byte] ^= 1 << bit
            path.write_bytes(changed)
            yield _read(kind, f"bit {bit} of byte {byte}", path, read)
    finally:
        path.write_bytes(whole)


def _read(kind: str, name: str, path: Path, read: Callable[[Path], object]) -> Attack:
    try:
        read(path)
    except ProbeError as error:
        return Attack(kind, name, "refused", str(error))
    except Exception as error:
        return Attack(kind, name, "crashed", repr(error)[:300])
    return Attack(kind, name, "read wrongly")
