"""Fingerprints as the cache keeps them, each by the bytes of the body that it is of."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import numpy as np

from probe.assets.cache import content_key
from probe.assets.mesh.fingerprint import Fingerprint
from probe.types import Array

FINGERPRINT_VERSION = "1"
"""Another one whenever `fingerprint` finds other numbers for the same body."""


def key_of_file(file: Path) -> str:
    """The key of a fingerprint: another body's file has another one, whatever its name."""
    return content_key("fingerprint", FINGERPRINT_VERSION, file.read_bytes())


def pack_fingerprint(fingerprint: Fingerprint) -> dict[str, Array]:
    """As an array; every digit is kept."""
    return {"numbers": np.array(fingerprint, dtype=np.float64)}


def unpack_fingerprint(stored: Mapping[str, Array]) -> Fingerprint:
    """The fingerprint that was packed."""
    return tuple(float(number) for number in stored["numbers"])
