"""Whether a folder is about the very suite that somebody has in hand."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from pathlib import Path

from probe.episodes.folder import SUITE
from probe.episodes.record import EpisodeRecord
from probe.errors import BadData
from probe.runs.checks.varied import difference_under
from probe.runs.variation import digest_of_tasks, read_variation
from probe.tasks.reserved import difference, unlike
from probe.tasks.suite import Suite
from probe.texts import plain


def check_reference(
    out: Path, suite: Suite, reference: Suite, records: Sequence[EpisodeRecord]
) -> None:
    """Refuse a folder whose suite isn't a given one, as it is or under the folder's conditions.

    Args:
        out: The folder.
        suite: Its suite.
        reference: What that has to be, name and all.
        records: The folder's records; they say under which conditions.

    Raises:
        BadData: It is another suite, or a part of it.
    """
    variation, differs = read_variation(out), difference
    if variation is not None and records:
        differs = partial(difference_under, records[0].conditions)
    reason = _in_name(suite, reference) or unlike(suite, reference, differs)
    if reason is None and len(suite.tasks) < len(reference.tasks):
        reason = f"it has {len(suite.tasks)} of its {len(reference.tasks)} tasks"
    if reason is None and suite.objects.keys() != reference.objects.keys():
        reason = "it has fingerprints of other objects"
    if reason is None and variation and variation.base != digest_of_tasks(reference.tasks):
        reason = "its tasks were made from others"
    if reason:
        words = f"isn't the suite {plain(reference.name)} that --suite names: {reason}"
        raise BadData(out / SUITE, words, "Ask for records of that one")


def _in_name(suite: Suite, reference: Suite) -> str | None:
    if suite.name != reference.name:
        return f'it is called "{plain(suite.name)}"'
    if suite.commitment != reference.commitment:
        return "it is committed to another salt, or to none"
    return None
