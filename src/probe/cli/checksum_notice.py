"""Says, once a file, that what was read has no checksum."""

from __future__ import annotations

from pathlib import Path

from probe.checksum import has_sum
from probe.cli.screen import say
from probe.episodes.files import without_checksum
from probe.episodes.folder import RECORDS, SUITE
from probe.reading import SUITE as SUITES
from probe.reading import contents
from probe.tasks.suite_file import packaged_suites, read_suite


def tell_unsummed(*folders: Path) -> None:
    """Say of which records, and which suites, a byte that has changed may go unnoticed.

    Args:
        folders: Of records, which have been read.
    """
    paths = [folder / RECORDS for folder in folders if (folder / RECORDS).exists()]
    if words := without_checksum(paths):
        say(words)
    bare = [path for folder in folders if _lacks_sum(path := folder / SUITE)]
    if bare:
        where = str(bare[0]) if len(bare) == 1 else f"{len(bare)} files of suites"
        say(
            f"{where}: no checksum. What has changed in a task is noticed all the same; in the "
            "fingerprint of an object only what is larger than the differences between machines."
        )


def _lacks_sum(path: Path) -> bool:
    """Whether a suite has neither a checksum nor the name of a packaged one, which it must be."""
    if not path.exists() or has_sum(contents(path, SUITES)):
        return False
    return read_suite(path).name not in packaged_suites()
