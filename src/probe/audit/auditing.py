"""Replays a folder's records in worker processes and keeps what came of each at once."""

from __future__ import annotations

from collections.abc import Generator, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from probe.audit.audit_file import ReplayVerdict, earlier, hash_of_line, is_foreign, keep
from probe.audit.replaying import Claim, Replayer, unable
from probe.engines.plan import Engine, LostUnit, WorkPlan
from probe.episodes.folder import reserved
from probe.episodes.ordered import Ordered, read_ordered
from probe.episodes.record import EpisodeRecord
from probe.runs.checks.folder import read_checked_lines
from probe.runs.checks.reference import check_reference
from probe.runs.variation import read_variation
from probe.scene.seeds import generator
from probe.tasks.suite import Suite
from probe.tasks.suite_file import packaged_suite, packaged_suites
from probe.tasks.task import Task


@dataclass
class Audit:
    """A folder under audit.

    Attributes:
        out: The folder.
        claims: Its records but for failures of ours, in the order of the file.
        key_file: Of whoever audits.
        missing: Episodes of the suite without a result, and of how many.
        foreign: Whether it came with an audit of somebody else, which is set aside.
        verdicts: What is known so far, by line.
    """

    out: Path
    claims: tuple[Claim, ...]
    key_file: Path
    missing: tuple[int, int] = (0, 0)
    foreign: bool = False
    verdicts: dict[str, ReplayVerdict] = field(default_factory=dict[str, ReplayVerdict])

    def lacking(self, count: int | None, seed: int = 0) -> list[Claim]:
        """Of so many claims, drawn by a seed, or of all, those without a verdict."""
        wanted: Sequence[Claim] = self.claims
        if count is not None and count < len(wanted):
            drawn = generator(seed, "audit").choice(len(wanted), count, replace=False)
            wanted = [self.claims[int(place)] for place in sorted(drawn)]
        return [claim for claim in wanted if claim.line not in self.verdicts]

    def keep(self) -> None:
        """Write down what is known."""
        keep(self.out, self.verdicts, len(self.claims), self.key_file)


def begin(out: Path, suite: Suite, key_file: Path, reference: Suite | None = None) -> Audit:
    """Check a folder's records, and take up what is known of replays of them.

    Args:
        out: The folder.
        suite: Its suite, which has been read.
        key_file: Of whoever audits; verdicts of anybody else are set aside.
        reference: What the suite has to be, if whoever audits has that.

    Raises:
        BadData: A record can't be read, or can't be of a run of the suite; or this is another one.
    """
    found = read_checked_lines(out, suite)
    records = [record for _, record in found]
    if reference is not None:
        check_reference(out, suite, reference, records)
    tasks = {task.id: task for task in suite.tasks}
    bases = _bases(out, suite, reference)
    claims = tuple(
        Claim(hash_of_line(line), record, tasks[record.task], bases.get(record.task))
        for line, record in found
        if record.end != "fault"
    )
    missing = missing_of(records, suite, read_ordered(out))
    foreign, known = is_foreign(out, key_file), earlier(out, key_file)
    audit = Audit(out, claims, key_file, missing, foreign, known)
    for claim in claims:
        if claim.line not in audit.verdicts and (reason := unable(claim.record)):
            audit.verdicts[claim.line] = ReplayVerdict(outcome="not replayable", reason=reason)
    return audit


def missing_of(records: Sequence[EpisodeRecord], suite: Suite, ordered: Ordered) -> tuple[int, int]:
    """How many episodes have no result, and of how many.

    Each agent in each setting should have each run of each task that was ordered, or that any has.
    """
    runs = {whose: set(range(count)) for whose, count in ordered.items()}
    for record in records:
        runs.setdefault((record.agent, record.setting), set()).add(record.run)
    found = {(it.task, it.agent, it.setting, it.run) for it in records if it.end != "fault"}
    total = len(suite.tasks) * max(1, sum(map(len, runs.values())))
    return total - len(found), total


def replay_claims(
    audit: Audit, claims: Sequence[Claim], place: Replayer, engine: Engine
) -> Generator[tuple[Claim, ReplayVerdict]]:
    """Replay some claims; yields each with its verdict once that is written down.

    Raises:
        BadData: A run is at work in the folder.
        OutputFailed: The disk is full.
        WorkerUnfit: A worker couldn't be set up.
        WorkerDied: Workers die before they begin.
    """
    with reserved(audit.out):
        plan = WorkPlan("audit", place, claims, lambda claim: claim.line)
        results = engine.carry_out(plan)
        try:
            for claim, result in results:
                audit.verdicts[claim.line] = verdict = _verdict(result)
                audit.keep()
                yield claim, verdict
        finally:
            results.close()


def whose(record: EpisodeRecord) -> str:
    """Which record, in words."""
    setting = f" ({record.setting})" if record.setting else ""
    return f"{record.task}, run {record.run} of {record.agent}{setting}"


def _verdict(result: bytes | LostUnit) -> ReplayVerdict:
    if isinstance(result, LostUnit):
        return ReplayVerdict(outcome="not replayable", reason=result.reason)
    return ReplayVerdict.model_validate_json(result)


def _bases(out: Path, suite: Suite, reference: Suite | None) -> dict[str, Task]:
    """The tasks that a folder's were made from under other conditions, if they are known."""
    if read_variation(out) is None:
        return {}
    if reference is None and suite.name in packaged_suites():
        reference = packaged_suite(suite.name)
    return {} if reference is None else {task.id: task for task in reference.tasks}
