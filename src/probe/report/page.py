"""The report: a folder that opens from disk, or one file. Scores, the suite, every episode."""

from __future__ import annotations

import base64
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from probe.episodes.conditions import RendererKind
from probe.episodes.tool_errors import hands_words
from probe.errors import BadData, ProbeError
from probe.files import write_text
from probe.generation.necessary import is_answerable_at_sight
from probe.reading import contents
from probe.report.build_log import Candidates
from probe.report.episodes import ReportEpisode, detail_of, index_of, keys_of
from probe.report.formats import FILTERS
from probe.report.highlight import highlight_of
from probe.report.outcome_figure import CLASSES, panels
from probe.report.rendering import digest, joined, script_json, write_page
from probe.report.result_words import TOO_FEW, result_words
from probe.report.steps_figure import HEIGHT, TICKS, WIDTH, curves, height
from probe.report.suite_facts import suite_facts
from probe.report.summary_tables import effort_table, missing_table, type_table, unknown_measures
from probe.scores.sight import sight_words
from probe.scores.summary import Scores
from probe.tasks.identity import identity_of
from probe.tasks.suite import Suite
from probe.toolshed.version import tools_words

LARGEST_SINGLE = 20
"""Episodes that a single file may hold; each brings some half a megabyte of pictures."""

PICTURES, EPISODES = "pictures", "episodes"
_STYLES = (
    *("base.css", "chart.css", "tables.css", "figure.css", "episodes.css"),
    *("replay.css", "timeline.css", "print.css"),
)
_SCRIPTS = (
    *("data.js", "clips.js", "large.js", "cards.js", "filters.js", "timeline.js", "overlays.js"),
    *("panel.js", "replay.js", "playing.js", "keys.js"),
)


class TooManyEpisodes(ProbeError):
    """A single file was asked for that no browser would like."""

    def __init__(self, episodes: int) -> None:
        super().__init__(
            f"A single file holds at most {LARGEST_SINGLE} episodes, and these are {episodes}. "
            "Leave out --single-file: the folder can be zipped."
        )


@dataclass(frozen=True)
class Report:
    """All that a report shows.

    Attributes:
        suite: What was asked.
        scores: Of everyone who answered.
        played: Every episode, those that count for nothing included; pictures lie in the report's
            folder of pictures.
        candidates: Of the suite's building, by type; empty if its log isn't known.
        files: Names of the tables that lie beside the page.
        audits: Name of each folder reported on, and how far it was audited, in words.
        renderer: What drew its pictures; "own" for what drew them for each agent.
    """

    suite: Suite
    scores: Scores
    played: tuple[ReportEpisode, ...]
    candidates: tuple[Candidates, ...] = ()
    files: tuple[str, ...] = ()
    audits: tuple[tuple[str, str], ...] = ()
    renderer: RendererKind = "own"

    @property
    def redrawn(self) -> tuple[str, ...]:
        """What drew pictures for agents that another renderer drew for the page; often nothing."""
        mine = self.renderer
        seen = {it.record.viewpoint.renderer for it in self.played if not it.record.frames}
        return () if mine == "own" else tuple(sorted(seen - {mine}))


def write_report(path: Path, report: Report, *, single: bool = False) -> None:
    """Write the page, and beside it a file for each episode unless it is to be a single file.

    Args:
        path: The page.
        report: What it shows.
        single: Everything goes into the page, pictures too.

    Raises:
        TooManyEpisodes: For a single file.
        OutputFailed: The disk is full, or the folder can't be written.
    """
    if single and len(report.played) > LARGEST_SINGLE:
        raise TooManyEpisodes(len(report.played))
    report = _in_order(report)
    if single:
        played = tuple(_inlined(each, path.parent) for each in report.played)
        report = replace(report, played=played)
    details = dict(zip(keys_of(report.played), map(detail_of, report.played), strict=True))
    if not single:
        for key, detail in details.items():
            script = f"probeEpisode({script_json(key)}, {script_json(detail)});\n"
            write_text(path.parent / EPISODES / f"{key}.js", script)
    values = _values(report) | {"details": script_json(details if single else {})}
    write_page(path, "report/index.html", values | _policy(single=single), FILTERS)


def _in_order(report: Report) -> Report:
    """Episodes by task, then by entrant, best first, then by run."""
    places = {task.id: place for place, task in enumerate(report.suite.tasks)}
    ranks = {card.entrant: rank for rank, card in enumerate(report.scores.cards)}
    played = sorted(
        report.played, key=lambda it: (places[it.task.id], ranks[it.row.entrant], it.row.run)
    )
    return replace(report, played=tuple(played))


def _policy(*, single: bool) -> dict[str, object]:
    """Styles and scripts, and the policy that lets the page load these and its own files alone."""
    style, script = joined("report", _STYLES), joined("report", _SCRIPTS)
    own = "" if single else "'self' file: "
    rules = (
        "default-src 'none'",
        f"style-src '{digest(style)}'",
        f"script-src {own}'{digest(script)}'",
        f"img-src {own}data:",
        f"media-src {own}data:",
        "base-uri 'none'",
        "form-action 'none'",
    )
    return {"style": style, "script": script, "policy": "; ".join(rules), "single": single}


def _values(report: Report) -> dict[str, object]:
    cards = report.scores.cards
    entrants = [card.entrant for card in cards]
    highlight = highlight_of(report.played)
    gaps = {card.entrant: card.gaps for card in cards}
    played = report.played
    return {
        "suite": report.suite,
        "identity": identity_of(report.suite),
        "scores": report.scores,
        "tools": tools_words(card.tools for card in cards),
        "hands": hands_words((each.record for each in played), report.suite.headline),
        "sight": sight_words(card.entrant.setting for card in cards),
        "cards": cards,
        "types": type_table(cards),
        "effort": effort_table(cards),
        "unknown": unknown_measures(cards),
        "missing": missing_table(cards),
        "repeated": [each for each in played if not each.counts],
        "faulted": [
            each
            for each in played
            if each.record.participation and each.record.participation.faults
        ],
        "panels": panels(cards),
        "classes": CLASSES,
        "curves": [curve for curve in curves(cards) if len(curve.points) > 1],
        "plane": (WIDTH, HEIGHT),
        "shares": [(share, height(share)) for share in TICKS],
        "highlight": highlight,
        "highlight_key": highlight and keys_of(played)[played.index(highlight.played)],
        "at_sight": any(map(is_answerable_at_sight, report.suite.tasks)),
        "facts": suite_facts(report.suite.tasks),
        "candidates": report.candidates,
        "files": report.files,
        "result": result_words(report.scores),
        "too_few": TOO_FEW,
        "audits": report.audits,
        "renderer": report.renderer,
        "redrawn": report.redrawn,
        "played": played,
        "index": script_json(index_of(played, entrants, gaps)),
    }


def _inlined(played: ReportEpisode, folder: Path) -> ReportEpisode:
    return replace(
        played,
        pictures=tuple(_data(folder / name) for name in played.pictures),
        clips=tuple((number, _data(folder / name)) for number, name in played.clips),
    )


def _data(path: Path) -> str:
    try:
        content = contents(path)
    except OSError as error:
        raise BadData(path, error.strerror or str(error), "Write the report again") from error
    kind = "video/webm" if path.suffix == ".webm" else "image/webp"
    return f"data:{kind};base64," + base64.b64encode(content).decode()


def addresses(names: Sequence[str]) -> tuple[str, ...]:
    """Of files in the folder of pictures, relative to the page."""
    return tuple(f"{PICTURES}/{name}" for name in names)
