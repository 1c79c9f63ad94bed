"""Graded episodes as a report shows them, and as the data that its script reads."""

from __future__ import annotations

import hashlib
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from probe.episodes.record import EpisodeRecord
from probe.report.truth_marks import truth_places
from probe.scores.missing import Gap
from probe.scores.row import Entrant, Row
from probe.tasks.task import Task


@dataclass(frozen=True)
class ReportEpisode:
    """One graded episode.

    Attributes:
        task: What was asked.
        record: What happened.
        row: What it was worth, and whose it is.
        counts: Whether it is the one of its run that scores rest on; a failure of ours that was
            run again isn't.
        pictures: Addresses of its pictures: the start, and the table after each step.
        clips: Addresses of films of its manipulations, by number of the step.
    """

    task: Task
    record: EpisodeRecord
    row: Row
    counts: bool
    pictures: tuple[str, ...]
    clips: tuple[tuple[int, str], ...] = ()

    @property
    def verdict(self) -> str:
        """Right, wrong, or missing: a failure of ours is neither."""
        return "missing" if self.row.missing else "right" if self.row.correct else "wrong"

    @property
    def outcome(self) -> str:
        """Why, in a word or two."""
        return "our fault" if self.row.missing else self.row.outcome


def keys_of(played: Iterable[ReportEpisode]) -> list[str]:
    """A short name for each, the same in every report of the same episodes."""
    seen: dict[str, int] = {}
    keys: list[str] = []
    for each in played:
        said = "\0".join([each.task.id, *each.row.entrant, str(each.row.run)])
        seen[said] = seen.get(said, 0) + 1
        keys.append(hashlib.sha256(f"{said}\0{seen[said]}".encode()).hexdigest()[:12])
    return keys


def index_of(
    played: Sequence[ReportEpisode],
    entrants: Sequence[Entrant],
    gaps: Mapping[Entrant, Sequence[Gap]],
) -> dict[str, Any]:
    """What the page knows of all episodes before one is opened.

    Args:
        played: All episodes.
        entrants: In the order of the page.
        gaps: What each of them lacks.
    """
    tasks = list({each.task.id: each.task for each in played}.values())
    place = {task.id: number for number, task in enumerate(tasks)}
    first = {each.task.id: each.pictures[0] for each in reversed(played)}
    never = [
        {"task": place[gap.task], "entrant": number, "run": gap.run}
        for number, entrant in enumerate(entrants)
        for gap in gaps.get(entrant, ())
        if gap.reason == NEVER_RUN and gap.task in place
    ]
    keys = keys_of(played)
    return {
        "entrants": [name_of(entrant) for entrant in entrants],
        "tasks": [{**_task(task), "picture": first[task.id]} for task in tasks],
        "episodes": [
            _episode(each, key, place[each.task.id], entrants.index(each.row.entrant))
            for key, each in zip(keys, played, strict=True)
        ],
        "never": never,
    }


NEVER_RUN = "never run"
"""The reason of a gap that no failure explains."""


def name_of(entrant: Entrant) -> str:
    """An entrant in one line; settings that are named after their agents aren't said twice."""
    return (
        entrant.agent
        if entrant.agent == entrant.setting
        else f"{entrant.agent} ({entrant.setting})"
    )


def _task(task: Task) -> dict[str, Any]:
    return {
        "id": task.id,
        "kind": task.question_type,
        "question": task.question,
        "options": [[option.letter, option.text] for option in task.options],
        "truth": task.answer,
    }


def _episode(played: ReportEpisode, key: str, task: int, entrant: int) -> dict[str, Any]:
    row = played.row
    return {
        "key": key,
        "task": task,
        "entrant": entrant,
        "run": row.run,
        "verdict": played.verdict,
        "outcome": played.outcome,
        "answer": row.answer,
        "fault": row.fault,
        "counts": played.counts,
        "turns": row.turns,
        "manipulations": row.manipulations,
        "picture_px": played.record.viewpoint.camera.width_px,
        # The script draws these on the pictures of a wrong answer.
        "true_places": truth_places(played.task, played.record)
        if played.verdict == "wrong"
        else [],
        "clips": dict(played.clips),
    }


def detail_of(played: ReportEpisode) -> dict[str, Any]:
    """All that happened in one episode, for its replay."""
    record = played.record
    answer = record.answer
    return {
        "start": played.pictures[0],
        "end": record.end,
        "answer": answer and {"choice": answer.choice, "point": answer.point_px},
        "steps": [
            {
                "tool": step.call.name,
                "arguments": step.call.arguments,
                "words": step.call.words,
                "status": step.status,
                "text": step.text,
                "point": step.point_px,
                "picture": picture,
            }
            for step, picture in zip(record.steps, played.pictures[1:], strict=True)
        ],
        # What a model said without calling a tool: all of it, where it has none.
        "said": [reply.words for reply in record.participation.replies if reply.words]
        if record.participation
        else [],
        "seconds": [played.row.seconds_agent, played.row.seconds_tools],
    }
