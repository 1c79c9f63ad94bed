"""The shortest agent: `probe run demo --limit 1 --agent examples/my_agent.py:Agent`."""

from collections.abc import Sequence

from probe import Call, Question, Turn


class Agent:
    """Looks at the table once, then answers with the first option."""

    def act(self, question: Question, history: Sequence[Turn]) -> Call | None:
        """The next call of a tool; None would end the episode without an answer."""
        if not history:
            return Call.of("perceive_scene")
        print(question.text, "\n", history[-1].result.text)  # goes to agent.log in the run's folder
        letter, _ = question.options[0]
        return Call.of("answer_question", {"choice": letter})
