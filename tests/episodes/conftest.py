"""An episode on a painted table."""

from __future__ import annotations

from collections.abc import Sequence

import pytest

from probe.episodes.run import run_episode
from probe.episodes.turns import Call, Question, Turn
from probe.perception.oracle import Oracle
from probe.scene.setup import UR5_TABLE
from probe.toolshed.toolshed import Toolshed
from tabletops import Block, Obedient, PaintedStation, spec

SPECS = {7: spec("red mug", "red"), 9: spec("white ball", "white")}
BLOCKS = (
    Block(7, (100, 100, 219, 219)),
    Block(9, (600, 450, 679, 529), height=0.08, colour=(240, 240, 240)),
)
QUESTION = Question("Where is the ball?", (("A", "here"), ("B", "there")))


class Fixed:
    """Makes these calls, then stops."""

    def __init__(self, *calls: Call) -> None:
        self.calls = calls

    def act(self, question: Question, history: Sequence[Turn]) -> Call | None:
        return self.calls[len(history)] if len(history) < len(self.calls) else None


CALLS = (
    Call.of("perceive_scene", words="Let me look."),
    Call.of("find_object", {"description": "red mug"}),
    Call.of("grasp_and_remove", {"object_id": "object_1"}),
    Call("push", '{"object_id": "object_1", "distance_cm": NaN}'),
    Call("find_object", "half a \ud800 pair"),
    Call.of("find_object", {"description": "white ball"}),
    Call.of("answer_question", {"choice": "B", "point": [640, 490]}),
)


@pytest.fixture
def fresh():
    """A function that gives a fresh table and its tools."""

    def make(kind: type[PaintedStation] = PaintedStation) -> tuple[PaintedStation, Toolshed]:
        station = kind(BLOCKS)
        tools = Toolshed(station, Oracle(SPECS), Obedient(), UR5_TABLE, pictures=False)
        return station, tools

    return make


@pytest.fixture
def play(fresh):
    """A function that runs calls on a fresh table."""

    def run(*calls: Call, kind: type[PaintedStation] = PaintedStation):
        station, tools = fresh(kind)
        agent = Fixed(*(calls or CALLS))
        return run_episode("t-1", QUESTION, agent, tools, station, agent_name="fixed", run=2)

    return run
