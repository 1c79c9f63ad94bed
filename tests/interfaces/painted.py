"""A server over a painted table; as a script it serves until its client leaves.

`python painted.py OUT [TURNS]`. Grasps take a second, so that something can happen meanwhile.
"""

from __future__ import annotations

import sys
import time
from pathlib import Path

TESTS = Path(__file__).resolve().parents[1]
if __name__ == "__main__":
    sys.path.insert(0, str(TESTS))

from probe.episodes.episode import Episode  # noqa: E402
from probe.episodes.turns import Question  # noqa: E402
from probe.interfaces.mcp_server import serve  # noqa: E402
from probe.interfaces.session import Session  # noqa: E402
from probe.perception.oracle import Oracle  # noqa: E402
from probe.scene.setup import UR5_TABLE  # noqa: E402
from probe.toolshed import toolshed  # noqa: E402
from tabletops import Block, Obedient, PaintedStation, spec  # noqa: E402

SPECS = {
    701: spec("red mug", "red"),
    702: spec("white ball", "white"),
    917: spec("yellow duck", "yellow", description="A rubber bird."),
}
BLOCKS = (
    Block(701, (100, 100, 219, 219)),
    Block(702, (600, 450, 679, 529), height=0.08, colour=(240, 240, 240)),
    Block(917, (605, 455, 640, 500), height=0.01),  # under the ball
)
QUESTION = Question("What is under the ball?", (("A", "a goose"), ("B", "a duck")))
SLOW = 1.0


class Slow(Obedient):
    """Takes its time."""

    def grasp_and_remove(self, station, frame, mask, drop_at):
        time.sleep(SLOW)
        return super().grasp_and_remove(station, frame, mask, drop_at)


def open_episode(run: int = 0) -> Episode:
    """A fresh episode."""
    station = PaintedStation(BLOCKS)
    tools = toolshed.Toolshed(station, Oracle(SPECS), Slow(), UR5_TABLE)
    question = Question(QUESTION.text, QUESTION.options, tools.first_picture())
    return Episode("duck-0815", question, tools, station, agent_name="mcp", run=run)


if __name__ == "__main__":
    if sys.argv[2:]:
        toolshed.TURNS = int(sys.argv[2])  # type: ignore[misc]
    session = Session(open_episode, Path(sys.argv[1]))
    serve(session, QUESTION)
    session.close()
