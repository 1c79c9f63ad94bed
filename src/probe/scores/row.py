"""One graded episode as a row of a table: what all statistics are made of."""

from __future__ import annotations

from typing import Annotated, NamedTuple

import pydantic

from probe.episodes.ordered import MOST_RUNS
from probe.episodes.record import End
from probe.tasks.grading import Outcome
from probe.tasks.task import Letter


class Entrant(NamedTuple):
    """Who is scored: an agent in a setting."""

    agent: str
    setting: str

    @property
    def title(self) -> str:
        """Both, for tables."""
        return f"{self.agent}, {self.setting}"


class Row(
    pydantic.BaseModel,
    frozen=True,
    extra="forbid",
    allow_inf_nan=False,
    validate_by_name=True,
    serialize_by_alias=True,
):
    """One run of one agent at one task; a field is None where it is unknown or says nothing.

    Attributes:
        suite, task: Names of the suite and of its task.
        question_type: Question type.
        stratum: Part of the type that is also reported apart: Find's "hidden" or "partly".
        options: Number of options to choose from.
        agent, setting, run: Who answered, how it was allowed to, and which of its runs this is.
        ordered: Runs of each task that it was to have; None where nobody wrote that down.
        answer, right: The letter it gave, and the right one.
        correct: The answer counts; in Find the point too.
        letter_correct: The letter alone is right.
        outcome, end: Why it counts or not, and why the episode ended.
        fault: What failed through no fault of the agent; the row is then *missing*, whatever else
            it says.
        turns, manipulations, perceptions: Calls in all; grasps and pushes carried out, failed
            ones included; looks at the scene and searches.
        turns_spent: The episode ended for want of turns.
        manipulations_spent: All manipulations that are allowed were used.
        manipulated: At least one manipulation was used.
        seconds_agent, seconds_tools: Wall time of both.
        tokens_in, tokens_out, cost: Of the model; the cost in US dollars.
        precision, recall, exact, attempts_a_removal, others_disturbed, strict: Of Reduce, how
            what was asked for was done; see probe.scores.fidelity.
        tools: Version of the tools; files leave it out where it is 1, as release 0.1 did.
        necessary: Fewest manipulations after which the answer can be seen; None of tasks that
            don't state it, and files then leave it out.
    """

    suite: str
    task: str
    question_type: Annotated[str, pydantic.Field(alias="kind")]
    stratum: str = ""
    options: int = pydantic.Field(ge=2)
    agent: str
    setting: Annotated[str, pydantic.Field(alias="arm")]
    run: int = pydantic.Field(ge=0)
    ordered: int | None = pydantic.Field(default=None, ge=1, le=MOST_RUNS)
    answer: Letter | None = None
    right: Letter
    correct: bool
    letter_correct: bool
    outcome: Outcome
    end: End
    fault: str | None = pydantic.Field(default=None, min_length=1)
    turns: int = pydantic.Field(ge=0)
    manipulations: int = pydantic.Field(ge=0)
    perceptions: int = pydantic.Field(ge=0)
    turns_spent: bool
    manipulations_spent: bool
    manipulated: bool
    seconds_agent: float | None = None
    seconds_tools: float | None = None
    tokens_in: int | None = None
    tokens_out: int | None = None
    cost: float | None = None
    precision: float | None = None
    recall: float | None = None
    exact: bool | None = None
    attempts_a_removal: float | None = None
    others_disturbed: int | None = None
    strict: bool | None = None
    tools: int = pydantic.Field(default=1, ge=1, exclude_if=lambda version: version == 1)
    necessary: int | None = pydantic.Field(default=None, ge=0, exclude_if=lambda it: it is None)

    @pydantic.model_validator(mode="after")
    def _agrees_with_itself(self) -> Row:
        if self.correct and not self.letter_correct:
            raise ValueError("it counts as right with a wrong letter")
        if self.letter_correct != (self.answer == self.right):
            raise ValueError("letter_correct isn't what the letters say")
        if (self.fault is not None) != (self.end == "fault"):
            raise ValueError("a fault has words, and nothing else has")
        if self.manipulated != (self.manipulations > 0):
            raise ValueError("manipulated isn't what the manipulations say")
        return self

    @property
    def entrant(self) -> Entrant:
        """Whose row it is."""
        return Entrant(self.agent, self.setting)

    @property
    def missing(self) -> bool:
        """Our failure ended it: neither right nor wrong."""
        return self.fault is not None
