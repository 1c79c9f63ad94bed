"""What decides how something made by formula looks: a hash of its code and data."""

from __future__ import annotations

from functools import cache as memo
from importlib.resources import files
from importlib.resources.abc import Traversable

import numpy as np

from probe.assets.cache import content_key


@memo
def recipe(package: str) -> str:
    """Hash of a package's files, those in its folders included, and of numpy's version."""
    return content_key(np.__version__, *_contents(files(package)))


def _contents(folder: Traversable) -> list[bytes]:
    found: list[bytes] = []
    for entry in sorted(folder.iterdir(), key=lambda entry: entry.name):
        if entry.is_dir() and entry.name != "__pycache__":
            found += _contents(entry)
        elif entry.is_file():
            found += [entry.name.encode(), entry.read_bytes()]
    return found
