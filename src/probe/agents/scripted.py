"""The rule-based agent: solves what its rules cover from the tools' words alone, else stops."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from probe.agents.asking_names import by_name, names_in
from probe.agents.moves import Plan, Way
from probe.agents.phrases import Say, silent
from probe.agents.type_plan import ScriptedQuestion, plan_for
from probe.episodes.turns import Call, Question, Turn
from probe.tasks.wordings import wordings


class Scripted:
    """Follows a plan for one question; an Agent.

    It is told the question's type and subject, since it can't read; of the table it knows what
    the tools tell. It stops without an answer unless it was shown the evidence.
    """

    def __init__(
        self,
        question_type: str,
        subject: str,
        rng: np.random.Generator,
        first: Way = "grasp",
        *,
        form: str = "plain",
        bold: bool = False,
        say: Say = silent,
    ) -> None:
        """Prepare for one episode.

        Args:
            question_type: Type of the question.
            subject: As in Task.
            rng: Breaks ties.
            first: What it tries first on things that are in the way.
            form: What exactly Compare and Size ask.
            bold: Whether it says what is likeliest, or guesses, where it lacks evidence. Such an
                answer proves nothing: never certify a task by it.
            say: Gives the words that go with each call; they change nothing that is done.
        """
        self._kind = question_type
        self._subject = subject
        self._rng = rng
        self._first: Way = first
        self._form = form
        self._bold = bold
        self._say = say
        self._plan: Plan[None] | None = None

    def act(self, question: Question, history: Sequence[Turn]) -> Call | None:
        """The next call; None where the plan gives up."""
        try:
            if self._plan is None:
                self._plan = self._planned(question)
                return next(self._plan)
            return self._plan.send(history[-1].result.text)
        except StopIteration:
            return None

    def _planned(self, question: Question) -> Plan[None]:
        asked = ScriptedQuestion(
            question, self._subject, self._form, self._first, self._rng, self._bold, self._say
        )
        plan = plan_for(self._kind).begin(asked)
        fixed = [wording.text for wording in wordings(self._kind)]
        return by_name(plan, names_in(question, self._subject, fixed))
