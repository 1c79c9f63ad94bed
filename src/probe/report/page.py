"""The report: one page that opens from disk, with a table of rates and every episode."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import jinja2

from probe.files import write_text
from probe.report.episode_view import EpisodeView
from probe.report.tally import rates


def write_report(path: Path, title: str, views: Sequence[EpisodeView]) -> None:
    """Write the page. All text is escaped: words of models and catalogues can't inject HTML."""
    environment = jinja2.Environment(
        loader=jinja2.PackageLoader("probe.report"),
        autoescape=True,
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    agents = sorted({view.record.agent for view in views})
    tables = {
        agent: rates([view for view in views if view.record.agent == agent]) for agent in agents
    }
    page = environment.get_template("report.html")
    write_text(path, page.render(title=title, tables=tables, views=views))
