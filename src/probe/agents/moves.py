"""Short sequences of calls that plans are made of. A plan yields calls and is sent the replies."""

from __future__ import annotations

from collections.abc import Generator
from typing import Literal, TypeVar

import numpy as np

from probe.agents.phrases import Say
from probe.agents.reading import (
    Graph,
    Outcome,
    Seen,
    grasp_outcome,
    read_graph,
    read_handle,
    worked,
)
from probe.agents.text_features import is_none
from probe.episodes.turns import Call, Question
from probe.types import PictureScale

T = TypeVar("T")
Plan = Generator[Call, str, T]
Way = Literal["grasp", "push"]

_STEPS = {"up": (0, -1), "down": (0, 1), "left": (-1, 0), "right": (1, 0)}
_SHORTEST_CM, _LONGEST_CM = 6.0, 15.0


def look(words: str = "") -> Plan[Graph]:
    """See what shows now."""
    text = yield Call.of("perceive_scene", words=words)
    return read_graph(text)


def move_away(
    seen: Seen,
    graph: Graph,
    way: Way,
    rng: np.random.Generator,
    say: Say,
    words: str,
    scale: PictureScale,
) -> Plan[Outcome]:
    """Grasp a thing or push it to where there is room; says what came of it.

    Args:
        seen: The thing.
        graph: What shows.
        way: What to do with it.
        rng: Breaks ties between directions.
        say: Gives words for the manipulation.
        words: Why it is to be moved.
        scale: Of the picture.
    """
    text = yield Call.of("find_object", {"description": seen.place}, words)
    handle = read_handle(text)
    if handle is None:
        return "unfound"
    thing = {"thing": seen.name or "thing"}
    if way == "grasp":
        words = say("do grasp", thing)
        text = yield Call.of("grasp_and_remove", {"object_id": handle}, words)
        return grasp_outcome(text)
    direction, distance = roomiest(seen, graph, rng, scale)
    arguments = {"object_id": handle, "direction": direction, "distance_cm": distance}
    words = say("do push", {**thing, "direction": direction})
    text = yield Call.of("push", arguments, words)
    return "pushed" if worked(text) else "blocked"


def answer(letter: str, point: tuple[int, int] | None = None, words: str = "") -> Plan[None]:
    """End with an answer."""
    arguments = {"choice": letter} if point is None else {"choice": letter, "point": list(point)}
    yield Call.of("answer_question", arguments, words)


def option_by_option(question: Question, letter: str, say: Say) -> str:
    """The options in words, up to the one that is right: for each whether it is.

    Args:
        question: Has the options.
        letter: Of the right one.
        say: Gives the words.
    """
    letters = [known for known, _ in question.options]
    told = question.options[: letters.index(letter) + 1]
    said = (
        say("option yes" if known == letter else "option no", {"letter": known, "text": text})
        for known, text in told
    )
    return " ".join(said).strip()


def none_of_them(question: Question) -> str | None:
    """Letter of "None of the above", if it is an option."""
    letters = [letter for letter, text in question.options if is_none(text)]
    return letters[0] if letters else None


def roomiest(
    seen: Seen, graph: Graph, rng: np.random.Generator, scale: PictureScale
) -> tuple[str, float]:
    """The direction in which a push meets least and stays in the picture, and how far, in cm."""
    order: list[str] = rng.permutation(sorted(_STEPS)).tolist()
    costs = {direction: _cost(seen, graph, direction, scale) for direction in order}
    best = min(order, key=lambda direction: costs[direction])
    return best, round(_length_cm(seen, best, scale), 1)


def _px_per_cm(scale: PictureScale) -> float:
    return scale.side_px / (100 * scale.width)


def _length_cm(seen: Seen, direction: str, scale: PictureScale) -> float:
    """As far as the thing is long that way, so that it leaves its place."""
    left, top, right, bottom = seen.box
    extent = right - left if direction in ("left", "right") else bottom - top
    return float(np.clip(extent / _px_per_cm(scale), _SHORTEST_CM, _LONGEST_CM))


def _cost(seen: Seen, graph: Graph, direction: str, scale: PictureScale) -> float:
    """Pixels of other things' boxes and of what lies outside the picture, in the path swept."""
    du, dv = _STEPS[direction]
    reach = round(_length_cm(seen, direction, scale) * _px_per_cm(scale))
    left, top, right, bottom = seen.box
    path = (
        min(left, left + du * reach),
        min(top, top + dv * reach),
        max(right, right + du * reach),
        max(bottom, bottom + dv * reach),
    )
    whole = (path[2] - path[0] + 1) * (path[3] - path[1] + 1)
    outside = whole - _overlap(path, (0, 0, scale.side_px - 1, scale.side_px - 1))
    others = (other for other in graph.objects if other.number != seen.number)
    return 2 * outside + sum(_overlap(path, other.box) for other in others)


def _overlap(a: tuple[int, int, int, int], b: tuple[int, int, int, int]) -> int:
    width = min(a[2], b[2]) - max(a[0], b[0]) + 1
    height = min(a[3], b[3]) - max(a[1], b[1]) + 1
    return max(width, 0) * max(height, 0)
