"""The random agent: valid calls without sense, then any letter. The floor of every comparison."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from probe.agents.reading import read_graph, read_handle
from probe.episodes.turns import Call, Question, Turn

_FEWEST, _MOST = 2, 12
_DIRECTIONS = ("up", "down", "left", "right")


class Random:
    """Makes between 2 and 12 calls, then answers with a letter by chance; an Agent."""

    def __init__(self, rng: np.random.Generator) -> None:
        self._rng = rng
        self._calls = int(rng.integers(_FEWEST, _MOST + 1))

    def act(self, question: Question, history: Sequence[Turn]) -> Call | None:
        """The next call."""
        points = _points(history) or [self._anywhere(question.scale.side_px)]
        point = points[int(self._rng.integers(len(points)))]
        if len(history) >= self._calls:
            letter = question.options[int(self._rng.integers(len(question.options)))][0]
            return Call.of("answer_question", {"choice": letter, "point": list(point)})
        handles = [h for turn in history if (h := read_handle(turn.result.text))]
        tool = int(self._rng.integers(4 if handles else 2))
        if tool == 0:
            return Call.of("perceive_scene")
        if tool == 1:
            place = f"the thing at ({point[0]}, {point[1]})"
            return Call.of("find_object", {"description": place})
        return self._manipulation(handles[-1], grasp=tool == 2)

    def _manipulation(self, handle: str, *, grasp: bool) -> Call:
        if grasp:
            return Call.of("grasp_and_remove", {"object_id": handle})
        direction = _DIRECTIONS[int(self._rng.integers(4))]
        distance = round(float(self._rng.uniform(3, 20)), 1)
        arguments = {"object_id": handle, "direction": direction, "distance_cm": distance}
        return Call.of("push", arguments)

    def _anywhere(self, side_px: int) -> tuple[int, int]:
        u, v = self._rng.integers(side_px, size=2).tolist()
        return u, v


def _points(history: Sequence[Turn]) -> list[tuple[int, int]]:
    """Points of what the last list showed."""
    for turn in reversed(history):
        if turn.call.name == "perceive_scene":
            return [seen.point for seen in read_graph(turn.result.text).objects]
    return []
