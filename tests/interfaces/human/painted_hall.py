"""A hall whose tables are painted; as a script it serves: `python painted_hall.py OUT [PORT]`."""

from __future__ import annotations

import sys
import threading
import time
from collections.abc import Generator
from contextlib import closing, contextmanager
from dataclasses import replace
from pathlib import Path

TESTS = Path(__file__).resolve().parents[2]
if __name__ == "__main__":
    sys.path.insert(0, str(TESTS))

from PIL import Image  # noqa: E402

from interfaces.painted import BLOCKS, SPECS, Slow  # noqa: E402
from probe.episodes.episode import Episode  # noqa: E402
from probe.episodes.folder import claim_setting, occupied  # noqa: E402
from probe.episodes.grading import answer_form, question_of  # noqa: E402
from probe.episodes.record import EpisodeRecord  # noqa: E402
from probe.files import encode  # noqa: E402
from probe.interfaces.human.feedback import Feedback  # noqa: E402
from probe.interfaces.human.session_manager import SessionManager  # noqa: E402
from probe.interfaces.human.table_places import TablePlace  # noqa: E402
from probe.perception.oracle import Oracle  # noqa: E402
from probe.scene.setup import UR5_TABLE  # noqa: E402
from probe.tasks.suite import Suite  # noqa: E402
from probe.tasks.task import Option, Task  # noqa: E402
from probe.toolshed.toolshed import Toolshed  # noqa: E402
from tabletops import PaintedStation, paint  # noqa: E402
from task_examples import FIND, SCENE  # noqa: E402

COUNT = replace(
    FIND,
    id="count-4567cdef",
    question_type="count",
    question='How many <b>mugs</b> & "balls" lie here?',
    options=(Option("A", "2"), Option("B", "3"), Option("C", "<script>4</script>")),
    answer="A",
)
SUITE = Suite("painted", (FIND, COUNT), {p.object_id: (1.0,) for p in SCENE.objects})

PRACTICE = replace(
    SUITE, tasks=tuple(replace(task, id=f"{task.id[:-1]}9") for task in SUITE.tasks), name="other"
)
_RGB = paint(BLOCKS).rgb
assert _RGB is not None
PNG = encode(Image.fromarray(_RGB), "PNG")


class Room:
    """Furnishes tables, and counts them. `gate` holds up whoever sets one."""

    def __init__(self, slow: float = 0.0) -> None:
        self.open = 0
        self.set = 0
        self.slow = slow
        self.gate = threading.Event()
        self.gate.set()

    @contextmanager
    def furnish(self) -> Generator[TablePlace]:
        self.open += 1
        yield TablePlace(self.set_table, self.explain)
        self.open -= 1

    def explain(self, task: Task, record: EpisodeRecord) -> Feedback:
        chosen = record.answer.choice if record.answer else None
        right = next(option for option in task.options if option.letter == task.answer)
        verdict = f"Right is {right.letter}, {right.text}."
        return Feedback(chosen == task.answer, verdict, "<b>It</b> shows.", (PNG, PNG))

    def set_table(self, task: Task, name: str, run: int) -> Episode:
        assert self.gate.wait(20)
        self.set += 1
        station = PaintedStation(BLOCKS)
        tools = Toolshed(
            station, Oracle(SPECS), _Hand(self.slow), UR5_TABLE, form=answer_form(task)
        )
        question = question_of(task, tools.first_picture())
        return Episode(task.id, question, tools, station, agent_name=name, run=run)


class _Hand(Slow):
    def __init__(self, seconds: float) -> None:
        super().__init__()
        self.seconds = seconds

    def grasp_and_remove(self, station, frame, mask, drop_at):
        time.sleep(self.seconds)
        return super(Slow, self).grasp_and_remove(station, frame, mask, drop_at)


def hall_in(
    out: Path, room: Room, seats: int = 4, practice: Suite | None = PRACTICE
) -> SessionManager:
    """A hall over a folder that is started if it isn't yet."""
    with occupied(out, SUITE):
        claim_setting(out, "human")
    return SessionManager(SUITE, out, room.furnish, seats, practice)


def secrets() -> set[str]:
    """What no reply may hold: ids and numbers of objects and tasks."""
    ids = {placed.object_id for placed in SCENE.objects}
    tasks = {task.id for task in (*SUITE.tasks, *PRACTICE.tasks)}
    return {*ids, "id_", "701", "702", "917", *tasks, "0815"}


if __name__ == "__main__":
    from probe.interfaces.human.server import run

    with closing(hall_in(Path(sys.argv[1]), Room())) as sessions:
        run(sessions, int(sys.argv[2]) if sys.argv[2:] else 0, print)
