"""The objects and tables that are here, by what the environment says of folders."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from probe.assets.folders import assets_folder, audit_key_file, cache_folder, library_folder
from probe.assets.library import (
    EVALUATION_POOL,
    TRAINING_POOL,
    Library,
    Pool,
    open_all,
    open_library,
)
from probe.assets.tables import table_ids

__all__ = [
    "EVALUATION_POOL",
    "TRAINING_POOL",
    "Pool",
    "assets_folder",
    "audit_key_file",
    "cache_folder",
    "everything",
    "library",
    "library_folder",
    "opener",
    "tables_for",
]


def opener(pool: Pool | None = None) -> Callable[[], Library]:
    """What opens the objects of a pool, or all that are here.

    Workers call it for themselves, by what the environment says where they are.
    """
    return partial(library, pool) if pool else everything


def library(pool: Pool) -> Library:
    """The objects of a pool; see open_library()."""
    return open_library(pool, assets_folder(), cache_folder(), library_folder())


def everything() -> Library:
    """All objects that suites are made of and that are here; see open_all()."""
    return open_all(assets_folder(), cache_folder(), library_folder())


def tables_for(pool: Pool) -> tuple[str, ...]:
    """Tables for scenes of a pool; a pool with procedural objects needs none from outside."""
    return table_ids(assets_folder() if pool in ("scans", "own", "all") else None)
