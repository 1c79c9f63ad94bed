"""Questions to practise on: their answers are told, nothing is written down, nothing counts."""

from __future__ import annotations

from probe.episodes.record import EpisodeRecord
from probe.episodes.remarks import Remark
from probe.interfaces.human.progress import HumanProgress
from probe.interfaces.human.words import NotNow
from probe.tasks.suite import Suite, selection
from probe.tasks.suite_file import demo_suite
from probe.tasks.task import Task


def practice_for(suite: Suite) -> Suite | None:
    """What people may practise on before a suite: the demo's tasks, without any of the suite's."""
    demo = demo_suite()
    measured = {task.id for task in suite.tasks}
    others = tuple(task for task in demo.tasks if task.id not in measured)
    return selection(demo, others, "practice") if others else None


class PracticeStore:
    """One person's practice, for as long as the seat is theirs; see SessionStore.

    Args:
        name: The person's.
        suite: What is practised on.
    """

    def __init__(self, name: str, suite: Suite) -> None:
        self.name = name
        self.progress = HumanProgress(suite.tasks, ())
        self.remarks: dict[str, Remark] = {}

    def earlier(self, task: Task) -> tuple[EpisodeRecord | None, int]:
        """Nothing has been kept; the number of the run."""
        return None, self.progress.run_of(task)

    def keep(self, record: EpisodeRecord) -> None:
        """Nothing is kept."""

    def end(self, record: EpisodeRecord) -> None:
        """Go on to the next question."""
        self.progress.add(record)

    def write(self) -> None:
        """Nothing is written."""

    def remark(self, task: Task, *, ambiguous: bool, note: str) -> None:
        """Refuse it.

        Raises:
            NotNow: Always.
        """
        raise NotNow("Practice questions take no remarks.")
