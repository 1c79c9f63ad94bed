"""Replays a folder's records in worker processes and keeps what came of each at once."""

from __future__ import annotations

from collections.abc import Generator, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from probe.audit.audit_file import ReplayVerdict, earlier, hashes_of_lines, is_foreign, keep
from probe.audit.replaying import Claim, Replayer, unable
from probe.episodes.folder import reserved
from probe.episodes.record import EpisodeRecord
from probe.runs.checks.folder import read_checked
from probe.runs.variation import read_variation
from probe.runs.worker_pool import LostJob, carry_out
from probe.tasks.suite import Suite, spaced
from probe.tasks.suite_file import packaged_suite, packaged_suites
from probe.tasks.task import Task


@dataclass
class Audit:
    """A folder under audit.

    Attributes:
        out: The folder.
        claims: Its records but for failures of ours, in the order of the file.
        key_file: Of whoever audits.
        foreign: Whether it came with an audit of somebody else, which is set aside.
        verdicts: What is known so far, by line.
    """

    out: Path
    claims: tuple[Claim, ...]
    key_file: Path
    foreign: bool = False
    verdicts: dict[str, ReplayVerdict] = field(default_factory=dict[str, ReplayVerdict])

    def lacking(self, count: int | None) -> list[Claim]:
        """Of so many claims, evenly spaced, or of all, those without a verdict."""
        wanted = self.claims if count is None else spaced(self.claims, count)
        return [claim for claim in wanted if claim.line not in self.verdicts]

    def keep(self) -> None:
        """Write down what is known."""
        keep(self.out, self.verdicts, len(self.claims), self.key_file)


def begin(out: Path, suite: Suite, key_file: Path) -> Audit:
    """Check a folder's records, and take up what is known of replays of them.

    Args:
        out: The folder.
        suite: Its suite, which has been read.
        key_file: Of whoever audits; verdicts of anybody else are set aside.

    Raises:
        BadData: A record can't be read, or can't be of a run of the suite.
    """
    records = read_checked(out, suite)
    tasks = {task.id: task for task in suite.tasks}
    bases = _bases(out, suite)
    lines = hashes_of_lines(out)
    claims = tuple(
        Claim(line, record, tasks[record.task], bases.get(record.task))
        for line, record in zip(lines, records, strict=True)
        if record.end != "fault"
    )
    audit = Audit(out, claims, key_file, is_foreign(out, key_file), earlier(out, key_file))
    for claim in claims:
        if reason := unable(claim.record):
            audit.verdicts[claim.line] = ReplayVerdict(outcome="not replayable", reason=reason)
    return audit


def replay_claims(
    audit: Audit, claims: Sequence[Claim], place: Replayer, workers: int
) -> Generator[tuple[Claim, ReplayVerdict]]:
    """Replay some claims; yields each with its verdict once that is written down.

    Raises:
        BadData: A run is at work in the folder.
        OutputFailed: The disk is full.
        WorkerUnfit: A worker couldn't be set up.
        WorkerDied: Workers die before they begin.
    """
    with reserved(audit.out):
        results = carry_out(place, claims, workers)
        try:
            for claim, result in results:
                audit.verdicts[claim.line] = verdict = _verdict(result)
                audit.keep()
                yield claim, verdict
        finally:
            results.close()


def whose(record: EpisodeRecord) -> str:
    """Which record, in words."""
    arm = f" ({record.arm})" if record.arm else ""
    return f"{record.task}, run {record.run} of {record.agent}{arm}"


def _verdict(result: bytes | LostJob) -> ReplayVerdict:
    if isinstance(result, LostJob):
        return ReplayVerdict(outcome="not replayable", reason=result.reason)
    return ReplayVerdict.model_validate_json(result)


def _bases(out: Path, suite: Suite) -> dict[str, Task]:
    """The packaged tasks that a folder's were made from, if they were and are known."""
    if read_variation(out) is None or suite.name not in packaged_suites():
        return {}
    return {task.id: task for task in packaged_suite(suite.name).tasks}
