"""In which order a session's episodes come: agents back to back, drawn anew for each set-up."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from probe.runs.session.events import SlotKey
from probe.runs.session.plan import SessionPlan
from probe.scene.seeds import generator


@dataclass(frozen=True)
class Slot:
    """One episode of a session.

    Attributes:
        task: Id of the task whose table is laid.
        run: Number of the agents' run at it.
        number: Which of the agents comes, from 1: all that the operator is told.
        agent: Its name in the records.
    """

    task: str
    run: int
    number: int
    agent: str

    @property
    def key(self) -> SlotKey:
        """What the log calls it by."""
        return SlotKey(task=self.task, run=self.run, number=self.number)


def slots_of(plan: SessionPlan, agents: Sequence[str]) -> tuple[Slot, ...]:
    """All episodes in order.

    Numbers are drawn for each task and run by themselves. What an agent did at one table tells
    nobody which number it has at the next.

    Args:
        plan: Of the session.
        agents: Their names in the records, in the plan's order.
    """
    found: list[Slot] = []
    for task in plan.tasks:
        for run in range(plan.runs):
            drawn = generator(plan.seed, "session", task, run).permutation(len(agents))
            names = [agents[int(place)] for place in drawn]
            found += [Slot(task, run, number, name) for number, name in enumerate(names, start=1)]
    return tuple(found)
