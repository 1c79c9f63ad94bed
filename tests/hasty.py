"""An agent with planted weaknesses: it never moves anything, and believes what it sees first."""

from __future__ import annotations

from collections.abc import Sequence

from probe import Call, Question, Turn


class Hasty:
    """Looks once, then says the first option; never "None of the above"."""

    def act(self, question: Question, history: Sequence[Turn]) -> Call | None:
        """A look, then the answer."""
        if not history:
            return Call.of("perceive_scene")
        return Call.of("answer_question", {"choice": question.options[0][0]})
