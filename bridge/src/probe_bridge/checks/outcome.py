"""What a check found."""

from __future__ import annotations

from dataclasses import asdict, dataclass
from typing import Any, Dict, NamedTuple, Tuple

PASSED, FAILED, SKIPPED = "passed", "failed", "skipped"


class Measure(NamedTuple):
    """A number that a check measured, with its unit ("" for a plain count)."""

    name: str
    value: float
    unit: str

    def __str__(self) -> str:
        return f"{self.name} {self.value:.3g} {self.unit}".strip()


@dataclass(frozen=True)
class Outcome:
    """What a check found.

    Attributes:
        check: Its name.
        verdict: PASSED, FAILED or SKIPPED.
        text: What was found, or why the check was skipped.
        fault: Short name of what is wrong; empty unless it failed.
        remedy: How to mend it; empty unless it failed.
        measures: What was measured.
    """

    check: str
    verdict: str
    text: str
    fault: str = ""
    remedy: str = ""
    measures: Tuple[Measure, ...] = ()

    def values(self) -> Dict[str, Any]:
        """The same as plain values, for a JSON file."""
        return {**asdict(self), "measures": [measure._asdict() for measure in self.measures]}


def passed(check: str, text: str, *measures: Measure) -> Outcome:
    """A check that found nothing wrong."""
    return Outcome(check, PASSED, text, measures=measures)


def failed(check: str, fault: str, text: str, remedy: str, *measures: Measure) -> Outcome:
    """A check that found a fault, and how to mend it."""
    return Outcome(check, FAILED, text, fault, remedy, measures)


def skipped(check: str, reason: str) -> Outcome:
    """A check that could not be made, or that nobody wanted."""
    return Outcome(check, SKIPPED, reason)
