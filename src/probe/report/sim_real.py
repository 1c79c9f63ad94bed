"""The page that sets agents in simulation beside the same agents on a robot."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from probe.report.formats import FILTERS
from probe.report.rendering import digest, joined, write_page
from probe.report.sim_real_figure import SIDE, TICKS, place, points_of
from probe.report.sim_real_words import causes_table, grouped, result_of, span, telling
from probe.scores.sim_real import SimReal

_STYLES = ("base.css", "chart.css", "tables.css", "sim_real.css", "print.css")


@dataclass(frozen=True)
class OperatorReason:
    """What an operator wrote about an episode on the robot."""

    task: str
    agent: str
    run: int
    verdict: str
    words: str


@dataclass(frozen=True)
class SimRealReport:
    """All that the page shows.

    Attributes:
        suite: Name of the robot's suite.
        found: The comparison.
        conditions: How the tools saw, in simulation and on the robot, in words.
        tools: What to say where both were played with different versions of the tools.
        reasons: Of every episode of a session; empty where there was none.
    """

    suite: str
    found: SimReal
    conditions: tuple[str, str]
    tools: str = ""
    reasons: tuple[OperatorReason, ...] = ()


def write_sim_real_page(path: Path, report: SimRealReport) -> None:
    """Write the page; it opens from disk and loads nothing from elsewhere.

    Raises:
        OutputFailed: The disk is full, or the folder can't be written.
    """
    style = joined("report", _STYLES)
    rules = ("default-src 'none'", f"style-src '{digest(style)}'", "base-uri 'none'")
    found = report.found
    values = {
        "report": report,
        "found": found,
        "style": style,
        "policy": "; ".join((*rules, "form-action 'none'")),
        "points": points_of(found.agents),
        "side": SIDE,
        "ticks": [(share, place(share)) for share in TICKS],
        "causes": causes_table(found),
        "telling": telling(found),
        "result": result_of(found),
        "left_out": grouped(found.tasks_left_out),
    }
    write_page(path, "report/sim_real.html", values, {**FILTERS, "span": span})
