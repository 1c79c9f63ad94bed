"""One episode in a few pictures, to begin a report with."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from probe.report.episodes import ReportEpisode
from probe.tasks.task import LETTERS
from probe.toolshed.result import MOVING


@dataclass(frozen=True)
class Shot:
    """A picture and what it shows; perhaps a film of how that came about."""

    picture: str
    caption: str
    clip: str | None = None

    @property
    def is_video(self) -> bool:
        """Whether the film takes a player; the others are moving pictures."""
        clip = self.clip or ""
        return clip.endswith(".webm") or clip.startswith("data:video")


@dataclass(frozen=True)
class Highlight:
    """An episode in a few pictures.

    Attributes:
        played: The episode.
        shots: In order of time.
        alike: How many episodes could have stood here as well.
    """

    played: ReportEpisode
    shots: tuple[Shot, ...]
    alike: int


def highlight_of(played: Iterable[ReportEpisode]) -> Highlight | None:
    """The shortest right episode that found something, moved it and then answered; else None.

    One whose answer names something comes before "none of the above".
    """
    fit = [(each, shots) for each in played if (shots := _shots(each))]
    if not fit:
        return None
    best, shots = min(fit, key=lambda found: _plainness(found[0]))
    return Highlight(best, shots, len(fit))


def _plainness(played: ReportEpisode) -> tuple[bool, int]:
    return played.row.answer == LETTERS[-1], len(played.record.steps)


def _shots(played: ReportEpisode) -> tuple[Shot, ...]:
    """Start, the thing found, the film if there is one, the table once it is moved.

    Nothing if there was no such thing.
    """
    steps = played.record.steps
    done = [i for i, s in enumerate(steps) if s.call.name in MOVING and s.status == "done"]
    if not done or played.verdict != "right":
        return ()
    last = done[-1]
    names = [(step.call.name, step.status) for step in steps[:last]]
    if ("find_object", "done") not in names:
        return ()
    found = last - 1 - names[::-1].index(("find_object", "done"))
    moved = "lifted into the basket" if steps[last].call.name == MOVING[0] else "pushed"
    clip = dict(played.clips).get(last + 1)
    film = (Shot(played.pictures[last], f"It is {moved}", clip),) if clip else ()
    return (
        Shot(played.pictures[0], "What the agent was shown"),
        Shot(played.pictures[found + 1], "What it asked for, found"),
        *film,
        Shot(played.pictures[last + 1], f"After it was {moved}"),
    )
