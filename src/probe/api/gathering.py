"""Run folders of one suite together: told apart, graded, drawn."""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from probe.api.grading import grade_folder
from probe.api.progress import Track, silent
from probe.api.rows import absent_of, rows_of
from probe.episodes.conditions import RendererKind
from probe.episodes.folder import SUITE
from probe.episodes.record import EpisodeRecord
from probe.errors import ProbeError
from probe.report.clips import collect_clips
from probe.report.episodes import ReportEpisode
from probe.report.page import LARGEST_SINGLE, PICTURES, TooManyEpisodes, addresses
from probe.report.scene_renderer import SceneRenderer
from probe.report.stills import Still, develop, file_of, stills_of
from probe.scores.missing import Absent, settled
from probe.scores.row import Entrant, Row
from probe.tasks.identity import identity_of
from probe.tasks.suite import Suite
from probe.tasks.suite_file import read_suite
from probe.tasks.task import Task


class OtherSuite(ProbeError):
    """Runs can't be compared."""

    def __init__(self, first: Path, other: Path, reason: str) -> None:
        super().__init__(
            f"{other} is about another suite than {first}: {reason}. "
            "Compare runs of one suite, or write a report of each."
        )


class NoRuns(ProbeError):
    """No folder, or no record in any, or a folder twice."""


@dataclass(frozen=True)
class _Entry:
    task: Task
    record: EpisodeRecord
    row: Row
    stills: tuple[Still, ...]


@dataclass(frozen=True)
class _Folder:
    entries: tuple[_Entry, ...]
    absent: tuple[Absent, ...]

    @property
    def entrants(self) -> set[Entrant]:
        return {it.row.entrant for it in self.entries} | {it.entrant for it in self.absent}


@dataclass(frozen=True)
class Gathered:
    """What folders hold.

    Attributes:
        played: Every episode, in the order of the suite.
        absent: Who was ordered in a folder and has no episode there.
    """

    played: tuple[ReportEpisode, ...]
    absent: tuple[Absent, ...]


def one_suite(runs: Sequence[Path]) -> Suite:
    """The suite that all folders are about.

    Raises:
        NoRuns: There is no folder, or one is there twice.
        OtherSuite: They are about several.
        BadData: A suite can't be read.
    """
    if not runs:
        raise NoRuns("No folder to report on. Name one that `probe run` wrote to.")
    if len({run.resolve() for run in runs}) < len(runs):
        raise NoRuns("A folder is named twice. Name each once.")
    suites = [read_suite(run / SUITE) for run in runs]
    for run, suite in zip(runs, suites, strict=True):
        if suite != suites[0]:
            raise OtherSuite(runs[0], run, _difference(suites[0], suite))
    return suites[0]


def gather(
    runs: Sequence[Path],
    suite: Suite,
    scene_renderer: SceneRenderer,
    out: Path,
    *,
    setting: str | None = None,
    renderer: RendererKind = "own",
    single: bool = False,
    track: Track = silent,
) -> Gathered:
    """Every episode of the folders, its pictures in the report's folder.

    Args:
        runs: Folders.
        suite: What all of them are about.
        scene_renderer: Where to draw.
        out: Folder of the report.
        setting: Of all agents; None for what is usual.
        renderer: What draws pictures: "own" for what drew them for each agent, or another.
        single: Stop before drawing if a single file can't hold them.
        track: Watches the work.

    Raises:
        NoRuns: No folder holds a record.
        TooManyEpisodes: For a single file.
    """
    folders = [_read(run, suite, scene_renderer, setting, renderer, track) for run in runs]
    folders = _told_apart(runs, folders)
    entries = [entry for some in folders for entry in some.entries]
    if not entries:
        raise NoRuns(f"There is no record in {runs[0]}. Let an agent work on the suite first.")
    if single and len(entries) > LARGEST_SINGLE:
        raise TooManyEpisodes(len(entries))
    order = {task.id: number for number, task in enumerate(suite.tasks)}
    entries.sort(key=lambda it: order[it.task.id])
    kept = [run / PICTURES for run in runs]
    _draw(entries, suite, scene_renderer, out / PICTURES, kept, track)
    counting = {id(row) for row in settled(entry.row for entry in entries)}
    played = tuple(
        ReportEpisode(
            entry.task,
            entry.record,
            entry.row,
            id(entry.row) in counting,
            addresses([file_of(still, suite.objects) for still in entry.stills]),
            collect_clips(entry.record, out, [run for run in runs if run != out]),
        )
        for entry in entries
    )
    return Gathered(played, tuple(it for some in folders for it in some.absent))


def _read(
    run: Path,
    suite: Suite,
    scene_renderer: SceneRenderer,
    setting: str | None,
    renderer: RendererKind,
    track: Track,
) -> _Folder:
    found = grade_folder(run, suite, scene_renderer, track)
    rows = rows_of(run, suite, found, setting, identity_of(suite).title)
    entries = (
        _Entry(task, record, row, stills_of(task, record, run, renderer))
        for (task, record, _), row in zip(found, rows, strict=True)
    )
    absent = absent_of(run, suite, [record for _, record, _ in found], setting)
    return _Folder(tuple(entries), tuple(absent))


def _told_apart(runs: Sequence[Path], folders: Sequence[_Folder]) -> list[_Folder]:
    """Agents that appear in the same setting in two folders get their folder's name added."""
    entrants = Counter(who for some in folders for who in some.entrants)
    shared = {who.agent for who, times in entrants.items() if times > 1}
    return [
        _called(some, name, shared) for name, some in zip(short_names(runs), folders, strict=True)
    ]


def _called(some: _Folder, folder: str, shared: Collection[str]) -> _Folder:
    """The same, with the folder's name added to those of shared agents."""

    def called(agent: str) -> str:
        return f"{agent} [{folder}]" if agent in shared else agent

    entries = (
        replace(it, row=it.row.model_copy(update={"agent": called(it.row.agent)}))
        for it in some.entries
    )
    absent = (
        replace(it, entrant=Entrant(called(it.entrant.agent), it.entrant.setting))
        for it in some.absent
    )
    return _Folder(tuple(entries), tuple(absent))


def short_names(folders: Sequence[Path]) -> list[str]:
    """The last parts of each path, as many as it takes to tell them apart."""
    parts = [folder.resolve().parts for folder in folders]
    for length in range(1, max(map(len, parts)) + 1):
        names = ["/".join(each[-length:]) for each in parts]
        if len(set(names)) == len(names):
            return names
    return [str(folder) for folder in folders]


def _draw(
    entries: Sequence[_Entry],
    suite: Suite,
    scene_renderer: SceneRenderer,
    out: Path,
    kept: Sequence[Path],
    track: Track,
) -> None:
    """Draw what isn't there yet; pictures of a folder that is reported on are taken over."""
    wanted = {
        out / file_of(still, suite.objects): (still, entry.task)
        for entry in entries
        for still in entry.stills
    }
    missing = [(path, *said) for path, said in wanted.items() if not path.exists()]
    others = [folder for folder in kept if folder != out]
    for path, still, task in track(missing, "Drawing") if missing else ():
        develop(still, task, path, scene_renderer, others)


def _difference(first: Suite, other: Suite) -> str:
    mine, theirs = ({task.id: task for task in suite.tasks} for suite in (first, other))
    if mine.keys() != theirs.keys():
        alone = len(mine.keys() ^ theirs.keys())
        if first.name == other.name:
            return (
                f"{alone} tasks of {first.name} are in only one of them. If both are parts of one "
                "suite, run them with the same --limit, --type and --task"
            )
        return f"{first.name} and {other.name} differ in {alone} tasks"
    changed = [name for name, task in mine.items() if task != theirs[name]]
    if changed:
        return f"their tasks {changed[0]} differ"
    return f"one is called {first.name}, the other {other.name}, or their objects differ"
