"""Which tasks of a suite are run: the options `--limit`, `--type` and `--task`."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

from tyro.conf import UseAppendAction, arg

from probe.cli.numbers import check_numbers
from probe.errors import BadData
from probe.tasks.suite import Suite, selection, spaced
from probe.tasks.task import QuestionType


@dataclass(frozen=True)
class TaskChoice:
    """Which tasks are run; by default all.

    Attributes:
        limit: Run so many tasks, evenly spaced over the suite, so that all question types have
            their part.
        type: Run the tasks of this question type; may be said several times.
        task: Run the task of this id; may be said several times.
    """

    limit: Annotated[int | None, arg(metavar="N")] = None
    type: UseAppendAction[tuple[QuestionType, ...]] = ()
    task: Annotated[UseAppendAction[tuple[str, ...]], arg(metavar="ID")] = ()

    def of(self, suite: Suite) -> Suite:
        """The suite, or the part of it that is asked for, under the same name.

        Raises:
            UnknownName: It has no such task.
            BadData: Options don't go together, or no task is left.
        """
        check_numbers({"--limit": self.limit})
        if self == TaskChoice():
            return suite
        if self.task and (self.limit is not None or self.type):
            other = "--type" if self.type else "--limit"
            raise BadData("--task", f"does nothing with {other}", "Leave one of the two out")
        wanted = {suite[id].id for id in self.task} or {task.id for task in suite.tasks}
        kept = [it for it in suite.tasks if it.id in wanted]
        if self.type:
            kept = [it for it in kept if it.question_type in self.type]
        if not kept:
            there = ", ".join(sorted({it.question_type for it in suite.tasks}))
            reason = f"suite {suite.name} has no task of it"
            raise BadData("--type", reason, f"It has: {there}")
        if self.limit is not None:
            kept = list(spaced(kept, self.limit))
        return selection(suite, tuple(kept), suite.name)
