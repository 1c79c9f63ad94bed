"""The report: one page that opens from disk, with a table of rates and every episode."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from probe.report.episode_view import EpisodeView
from probe.report.rendering import write_page
from probe.report.tally import rates


def write_report(path: Path, title: str, views: Sequence[EpisodeView]) -> None:
    """Write the page, with a table of rates for each agent."""
    agents = sorted({view.record.agent for view in views})
    tables = {
        agent: rates([view for view in views if view.record.agent == agent]) for agent in agents
    }
    write_page(path, "report.html", {"title": title, "tables": tables, "views": views})
