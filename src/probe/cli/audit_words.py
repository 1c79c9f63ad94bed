"""What `probe audit` says of a folder: its suite, what is missing, what came of replays."""

from __future__ import annotations

from collections import Counter
from pathlib import Path

from probe.audit.audit_file import AUDIT, ReplayVerdict
from probe.audit.auditing import Audit, whose
from probe.cli.screen import say
from probe.runs.variation import read_variation
from probe.tasks.identity import identity_of
from probe.tasks.suite import Suite
from probe.tasks.suite_file import packaged_suites

_SHOWN = 10


def tell_checks(out: Path, suite: Suite, audit: Audit) -> None:
    """What the checks found; they would have raised what doesn't agree."""
    identity = identity_of(suite)
    say(
        f"{out}: {len(audit.claims)} results on {identity.title}{_under(out, suite)}. "
        "All agree with themselves, their tasks and the folder's notes; "
        f"{_missing(*audit.missing)}."
    )
    if identity.remark:
        say(f"{out}: {identity.remark}.")
    if audit.foreign:
        say(f"{out}: {AUDIT} was not made here: its verdicts don't count.")


def _missing(missing: int, total: int) -> str:
    if not missing:
        return f"of {total} episodes none is missing"
    return f"{missing} of {total} episodes {'is' if missing == 1 else 'are'} missing"


def _under(out: Path, suite: Suite) -> str:
    """In what a folder's tasks are or aren't those of the package."""
    if variation := read_variation(out):
        return f", under {variation.conditions}"
    return ", as packaged" if suite.name in packaged_suites() else ""


def tell_verdicts(audit: Audit) -> None:
    """Each record that differs, and how many can't be replayed for which reason."""
    known = [(it, audit.verdicts[it.line]) for it in audit.claims if it.line in audit.verdicts]
    differing = [(it, verdict) for it, verdict in known if verdict.outcome == "differs"]
    for claim, verdict in differing[:_SHOWN]:
        say(f"{whose(claim.record)} differs: {verdict.reason}")
    if len(differing) > _SHOWN:
        say(f"... and {len(differing) - _SHOWN} more, in audit.json.")
    unable = Counter(_reason(verdict) for _, verdict in known)
    for reason, count in unable.items():
        if reason:
            say(f"{count} can't be replayed: {reason}")


def _reason(verdict: ReplayVerdict) -> str:
    return verdict.reason if verdict.outcome == "not replayable" else ""
