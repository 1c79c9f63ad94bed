"""Where the environment says that assets lie, and where computed things go.

Only what people start reads these: the command line, and the harness's own.
"""

from __future__ import annotations

import os
from pathlib import Path

UNFINISHED = ".fetching"
"""Folder within that of fetched scans, until all are there."""


def assets_folder() -> Path | None:
    """The folder of extra assets: PROBE_ASSETS, or what was fetched; None if there is neither."""
    named = os.environ.get("PROBE_ASSETS")
    if named:
        return Path(named)
    fetched = fetched_folder()
    # Other suites mustn't fail over scans that are still on their way.
    whole = fetched.is_dir() and not (fetched / "scans" / UNFINISHED).exists()
    return fetched if whole else None


def fetched_folder() -> Path:
    """Where scans are fetched to unless PROBE_ASSETS is set: XDG_DATA_HOME/probe/assets."""
    return _data_folder() / "assets"


def cache_folder() -> Path:
    """Where computed things are kept: XDG_CACHE_HOME/probe or ~/.cache/probe."""
    return Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") / "probe"


def library_folder() -> Path:
    """The user's own objects: PROBE_LIBRARY, or XDG_DATA_HOME/probe/objects (~/.local/share)."""
    named = os.environ.get("PROBE_LIBRARY")
    return Path(named) if named else _data_folder() / "objects"


def audit_key_file() -> Path:
    """The secret key of this user's audits: XDG_DATA_HOME/probe/audit.key (~/.local/share)."""
    return _data_folder() / "audit.key"


def _data_folder() -> Path:
    home = os.environ.get("XDG_DATA_HOME") or Path.home() / ".local" / "share"
    return Path(home) / "probe"
