"""Findings as a Markdown table, the worst first within each type."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence

from probe.shortcuts.findings import LEVEL, Finding, detectable
from probe.tasks.task import QUESTION_TYPES

_HEAD = """\
| by | right | of n | 95 % (Wilson) | limit | p | corrected | verdict |
|---|---|---|---|---|---|---|---|"""


def markdown(findings: Sequence[Finding]) -> str:
    """All findings, by type, after what they amount to."""
    parts = [_summary(findings)]
    for question_type in dict.fromkeys(
        finding.hits.question_type for finding in _in_order(findings)
    ):
        mine = [finding for finding in findings if finding.hits.question_type == question_type]
        mine.sort(key=lambda finding: finding.hits.limit - finding.hits.accuracy)
        parts.append("\n".join([f"### {question_type}", "", _HEAD, *map(_row, mine)]))
    return "\n\n".join(parts) + "\n"


def leaks(findings: Sequence[Finding]) -> list[Finding]:
    """Those that can't be luck."""
    return [finding for finding in findings if finding.verdict == "above"]


def _in_order(findings: Sequence[Finding]) -> list[Finding]:
    return sorted(findings, key=lambda f: (_place(f.hits.question_type), f.hits.question_type))


def _place(question_type: str) -> int:
    return [name for name, known in enumerate(QUESTION_TYPES) if question_type.startswith(known)][0]


def _summary(findings: Sequence[Finding]) -> str:
    counts = Counter(finding.verdict for finding in findings)
    head = (
        f"{len(findings)} tests: {counts['below']} below their limit, {counts['within noise']} "
        f"over it within noise, {counts['above']} above it at {LEVEL:.0%} after Holm's correction."
    )
    rows = ["| type | n | by classifiers | limit | true accuracy called a leak (80 % power) |"]
    rows.append("|---|---|---|---|---|")
    for question_type in dict.fromkeys(
        finding.hits.question_type for finding in _in_order(findings)
    ):
        mine = [finding.hits for finding in findings if finding.hits.question_type == question_type]
        hits = max(mine, key=lambda t: t.ceiling)
        # Classifiers predict fewer than rules do.
        fewest, most = min(t.n for t in mine), max(t.n for t in mine)
        least = detectable(fewest, hits.ceiling, hits.allowance, len(findings))
        rows.append(f"| {question_type} | {most} | {fewest} | {hits.limit:.0%} | {least:.0%} |")
    return head + "\n\n" + "\n".join(rows)


def _row(finding: Finding) -> str:
    hits = finding.hits
    verdict = f"**{finding.verdict}**" if finding.verdict == "above" else finding.verdict
    cells = (
        hits.by,
        f"{hits.accuracy:.1%}",
        str(hits.n),
        f"{finding.low:.1%} to {finding.high:.1%}",
        f"{hits.limit:.1%}",
        f"{finding.p:.2g}",
        f"{finding.adjusted:.2g}",
        verdict,
    )
    return f"| {' | '.join(cells)} |"
