"""The checks as a command: outcomes are printed as they come."""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import List, Optional

from probe_bridge.checks.kit import Kit
from probe_bridge.checks.outcome import FAILED, Outcome

WARNING = (
    "The robot will move: straight to its home position, each joint by 3 degrees, the hand to\n"
    "and fro by 10 degrees where it is, and the empty hand open and shut. Keep a hand on the\n"
    "emergency stop, and the arm's surroundings free. Press Enter to go on; end the input\n"
    "(Ctrl-D) to check only what doesn't move."
)


def check_robot(address: str, token: str, certificate: Optional[Path], out: Optional[Path]) -> int:
    """Check a robot, asking before it moves; returns the exit status, 1 if something failed."""
    kit = Kit(address, token, certificate, show)
    if kit.reach():
        print(WARNING, flush=True)
        kit.see_and_move(bool(sys.stdin.readline()))
    if out:
        write(kit.outcomes, out)
    bad = sum(outcome.verdict == FAILED for outcome in kit.outcomes)
    print(f"{len(kit.outcomes)} checks, {bad} failed.")
    return 0 if kit.well else 1


def show(outcome: Outcome) -> None:
    """Print an outcome."""
    fault = f" [{outcome.fault}]" if outcome.fault else ""
    print(f"{outcome.verdict:8}{outcome.check}{fault}: {outcome.text}", flush=True)
    if outcome.measures:
        print(" " * 8 + "; ".join(str(measure) for measure in outcome.measures))
    if outcome.remedy:
        print(" " * 8 + outcome.remedy)


def write(outcomes: List[Outcome], out: Path) -> None:
    """Write outcomes as JSON."""
    rows = [outcome.values() for outcome in outcomes]
    out.write_text(json.dumps(rows, indent=1) + "\n", encoding="utf-8")
