"""Graded episodes and reports that tests make by hand."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from probe.episodes.record import EpisodeRecord
from probe.report.episodes import ReportEpisode
from probe.report.page import Report, write_report
from probe.scores.marking import roster_of_tasks, row_of
from probe.scores.missing import settled
from probe.scores.summary import summarise
from probe.tasks.grading import Score
from probe.tasks.task import Task
from run_folders import DEMO

TASKS = {task.id: task for task in DEMO.tasks}


def played(
    record: EpisodeRecord, *, setting: str = "agentic", counts: bool = True
) -> ReportEpisode:
    """A record, graded by its letter alone."""
    task = TASKS[record.task]
    said = record.answer.choice if record.answer else None
    right = said == task.answer
    score = Score(right, right, "right" if right else "wrong" if said else "unanswered")
    row = row_of(task, record, score, suite=DEMO.name, setting=setting)
    pictures = tuple(f"pictures/{number}.webp" for number in range(len(record.steps) + 1))
    return ReportEpisode(task, record, row, counts, pictures)


def report_of(episodes: Sequence[ReportEpisode], tasks: Sequence[Task] = DEMO.tasks) -> Report:
    rows = settled(each.row for each in episodes)
    scores = summarise(DEMO.name, rows, roster_of_tasks(tasks))
    return Report(DEMO, scores, tuple(episodes), files=("rows.csv",))


def write_page(folder: Path, episodes: Sequence[ReportEpisode]) -> str:
    """The HTML of a report of episodes."""
    write_report(folder / "index.html", report_of(episodes))
    return (folder / "index.html").read_text()
