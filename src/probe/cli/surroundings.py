"""What the environment says: where assets lie and where the cache goes."""

from __future__ import annotations

import os
from pathlib import Path

from probe.assets.library import Library, Pool, open_all, open_library
from probe.assets.tables import table_ids

__all__ = [
    "Pool",
    "assets_folder",
    "cache_folder",
    "everything",
    "library",
    "library_folder",
    "tables_for",
]


def assets_folder() -> Path | None:
    """The folder of extra assets, from PROBE_ASSETS; None if it isn't set."""
    folder = os.environ.get("PROBE_ASSETS")
    return Path(folder) if folder else None


def cache_folder() -> Path:
    """Where computed things are kept: XDG_CACHE_HOME/probe or ~/.cache/probe."""
    return Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") / "probe"


def library_folder() -> Path:
    """The user's own objects: PROBE_LIBRARY, or XDG_DATA_HOME/probe/objects (~/.local/share)."""
    named = os.environ.get("PROBE_LIBRARY")
    home = os.environ.get("XDG_DATA_HOME") or Path.home() / ".local" / "share"
    return Path(named) if named else Path(home) / "probe" / "objects"


def library(pool: Pool) -> Library:
    """The objects of a pool."""
    return open_library(pool, assets_folder(), cache_folder(), library_folder())


def everything() -> Library:
    """All objects that suites are made of: scans too where their folder is known."""
    return open_all(assets_folder(), cache_folder())


def tables_for(pool: Pool) -> tuple[str, ...]:
    """Tables for scenes of a pool; those of procedural objects need nothing from outside."""
    return table_ids(None if pool == "procedural" else assets_folder())
