"""At which step of using the tools a model fails, from its records. Pure.

Each rung needs the one before: a call in the right form, a place that a list told, an object_id
that holds, and then the right answer.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field

from probe.agents.reading import handle_refused, read_graph
from probe.episodes.record import EpisodeRecord, Step
from probe.perception.places import place_in
from probe.runs.checks.calls import request_of
from probe.scores.row import Entrant
from probe.toolshed.result import MOVING

_APART_PX = 2.0
"""A place is a listed one at this distance at most: thousandths are about a pixel apart."""

Place = tuple[float, float]


@dataclass(frozen=True)
class Share:
    """So many of so many."""

    part: int = 0
    whole: int = 0

    def __add__(self, other: Share) -> Share:
        """Both together."""
        return Share(self.part + other.part, self.whole + other.whole)

    def __str__(self) -> str:
        """In words: "95.0 % (19 of 20)"."""
        if not self.whole:
            return "none"
        return f"{100 * self.part / self.whole:.1f} % ({self.part} of {self.whole})"


@dataclass(frozen=True)
class Rungs:
    """How far somebody gets.

    Attributes:
        formed: Replies that a tool could be called by, of all that should have called one.
        listed: Places in find_object that a list told, of a thing that the last list still has; of
            all that were given as numbers.
        holding: Grasps and pushes whose object_id was given out and holds; of all well-formed ones,
            as long as manipulations were left.
        answered: Episodes with an answer.
        right: Episodes that were right.
    """

    formed: Share = Share()
    listed: Share = Share()
    holding: Share = Share()
    answered: Share = Share()
    right: Share = Share()

    def __add__(self, other: Rungs) -> Rungs:
        """Of both together."""
        return Rungs(
            self.formed + other.formed,
            self.listed + other.listed,
            self.holding + other.holding,
            self.answered + other.answered,
            self.right + other.right,
        )


@dataclass
class _Lists:
    """What the lists have told so far: points by object_id, and what the last one has."""

    points: dict[str, list[Place]] = field(default_factory=dict[str, list[Place]])
    last: list[str] = field(default_factory=list[str])

    def read(self, text: str) -> None:
        """Take in a list of perceive_scene."""
        seen = [it for it in read_graph(text).objects if it.object_id is not None]
        self.last = [str(it.object_id) for it in seen]
        for it in seen:
            self.points.setdefault(str(it.object_id), []).append(it.point)

    def have(self, place: Place) -> bool:
        """Whether a place is one that was told of a thing in the last list.

        Lists in short tell a point once, as long as its object_id holds.
        """
        return any(
            max(abs(place[0] - u), abs(place[1] - v)) <= _APART_PX
            for id in self.last
            for u, v in self.points[id]
        )


def rungs_of(record: EpisodeRecord, *, right: bool) -> Rungs:
    """How far one episode got.

    Args:
        record: Of an agent with tools; not of an episode that our own fault ended.
        right: Whether its answer was right.
    """
    lists, found = _Lists(), Rungs()
    for step in record.steps:
        found += _of_step(step, lists, record.viewpoint.camera.width_px)
        if step.call.name == "perceive_scene" and step.status == "done":
            lists.read(step.text)
    ends = Rungs(answered=Share(int(record.answer is not None), 1), right=Share(int(right), 1))
    return found + Rungs(formed=Share(0, _wordless(record))) + ends


def _wordless(record: EpisodeRecord) -> int:
    """Replies in which no call could be read."""
    seat = record.participation
    return sum(it.calls == 0 for it in seat.replies) if seat else 0


def _of_step(step: Step, lists: _Lists, side_px: int) -> Rungs:
    lost = handle_refused(step.text)
    # Tools call malformed, too, what fits them and not this table or question: an object_id that
    # doesn't hold, which is another rung, a letter without an option, an answer without its point.
    formed = step.status != "malformed" or lost or request_of(step, side_px) is not None
    listed = holding = Share()
    if formed and step.call.name in MOVING and step.status != "refused":
        # Once no manipulation is left, nobody looks at the object_id.
        holding = Share(int(not lost), 1)
    if formed and step.call.name == "find_object" and (place := _place(step)) is not None:
        listed = Share(int(lists.have(place)), 1)
    return Rungs(Share(int(formed), 1), listed, holding)


def _place(step: Step) -> Place | None:
    """The place in pixels that a find_object gives as numbers."""
    values = step.call.values
    return place_in(str(values.get("description"))) if isinstance(values, dict) else None


def ladder(episodes: Iterable[tuple[Entrant, EpisodeRecord, bool]]) -> dict[Entrant, Rungs]:
    """How far each entrant gets, in the order in which they appear.

    Args:
        episodes: Who played, the record, and whether it was right; without faults of ours.
    """
    found: dict[Entrant, Rungs] = {}
    for entrant, record, right in episodes:
        found[entrant] = found.get(entrant, Rungs()) + rungs_of(record, right=right)
    return found


def markdown(found: Sequence[tuple[str, Rungs]]) -> str:
    """The ladder as a table of Markdown.

    Args:
        found: Of whom, in words, and how far they get.
    """
    lines = [
        "|  | well-formed calls | find_object at a listed place | object_ids that hold "
        "| answered | right |",
        "|---|---|---|---|---|---|",
    ]
    for name, it in found:
        shares = (it.formed, it.listed, it.holding, it.answered, it.right)
        lines.append(f"| {name} | {' | '.join(map(str, shares))} |")
    return "\n".join(lines)
