"""What a session on a robot is to be: a file that its operator writes."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Literal

import pydantic

from probe.episodes.ordered import MOST_RUNS
from probe.errors import BadData
from probe.tasks.suite import Suite, selection
from probe.tasks.type_rules import rules_of
from probe.yaml_file import read_yaml

_REMEDY = "See docs/how-to/robot-session.md"

_Words = Annotated[str, pydantic.StringConstraints(strip_whitespace=True, min_length=1)]


class SessionPlan(pydantic.BaseModel, frozen=True, extra="forbid"):
    """The file.

    Attributes:
        suite: Whose tasks: a name, or a file.
        tasks: Ids of those that are laid, in this order.
        agents: Who is compared: names that `probe run --agent` knows, or "FILE.py:ClassName".
        runs: Episodes of each agent at each task.
        perception: What the tools see with; a robot has no labels.
        enrolment: The operator's list of objects, for "enrolled".
        seed: Of the order in which the agents come.
        operator: Who lays the tables.
    """

    version: Literal[1] = 1
    suite: _Words
    tasks: tuple[_Words, ...] = pydantic.Field(min_length=1)
    agents: tuple[_Words, ...] = pydantic.Field(min_length=1)
    runs: int = pydantic.Field(default=1, ge=1, le=MOST_RUNS)
    perception: Literal["segmenter", "enrolled"] = "segmenter"
    enrolment: Path | None = None
    seed: int = pydantic.Field(ge=0)
    operator: _Words

    @pydantic.model_validator(mode="after")
    def _names_each_once(self) -> SessionPlan:
        for field in (self.tasks, self.agents):
            twice = sorted({name for name in field if field.count(name) > 1})
            if twice:
                raise ValueError(f"{twice[0]} is named twice")
        return self


def read_plan(path: Path) -> SessionPlan:
    """Read a session's file, YAML or JSON.

    Raises:
        BadData: It is missing, or a field is invalid; the message names the field.
    """
    return read_yaml(path, SessionPlan, _REMEDY)


def tasks_of(plan: SessionPlan, suite: Suite) -> Suite:
    """The part of a suite that a session is about.

    Raises:
        UnknownName: A task isn't in it.
        BadData: A task is graded by where things lie, which a robot's record doesn't tell.
    """
    tasks = tuple(suite[name] for name in plan.tasks)
    for task in tasks:
        rules = rules_of(task.question_type)
        if rules.pointed or rules.exact:
            asks = "asks for a point" if rules.pointed else "is graded by where things lie"
            reason = f"{asks}, and without poses nobody can say whether it is right"
            raise BadData(task.id, reason, "Choose tasks that a letter answers")
    return selection(suite, tasks, suite.name)
