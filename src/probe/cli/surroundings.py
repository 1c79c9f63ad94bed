"""What the environment says: where assets lie and where the cache goes."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Literal

from probe.assets.library import Library, open_library

Pool = Literal["procedural", "scans", "all"]


def assets_folder() -> Path | None:
    """The folder of extra assets, from PROBE_ASSETS; None if it isn't set."""
    folder = os.environ.get("PROBE_ASSETS")
    return Path(folder) if folder else None


def cache_folder() -> Path:
    """Where computed things are kept: XDG_CACHE_HOME/probe or ~/.cache/probe."""
    return Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") / "probe"


def library(pool: Pool) -> Library:
    """The objects of a pool."""
    return open_library(pool, assets_folder(), cache_folder())
