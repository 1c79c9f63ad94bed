"""`probe merge`: shards of a run become one run."""

from __future__ import annotations

from pathlib import Path

from probe.cli.checksum_notice import tell_unsummed
from probe.cli.metavars import RunFolders
from probe.cli.screen import say
from probe.errors import BadData
from probe.runs.merge import merge_folders


def merge(parts: RunFolders, out: Path) -> None:
    """Join folders of records that `probe run --shard` wrote.

    Args:
        parts: The folders; none may hold an episode that another holds.
        out: Folder for all of them; a new one.
    """
    if not parts:
        raise BadData("probe merge", "was given no folder", "Name those that `--shard` wrote")
    tell_unsummed(*parts)
    say(f"{merge_folders(parts, out)} records are in {out}; `probe report {out}` shows them.")
