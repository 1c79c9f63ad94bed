"""An agent in a file: `probe run demo --agent examples/agent.py:LiftWhatIsNamed`."""

from __future__ import annotations

from collections.abc import Sequence

from probe import Call, Question, Turn, read_graph, read_handle


class LiftWhatIsNamed:
    """Lifts what the question names, and answers with what has come to light."""

    def act(self, question: Question, history: Sequence[Turn]) -> Call | None:
        """The next call, from the question and all turns so far; None ends the episode."""
        graphs = [read_graph(t.result.text) for t in history if t.call.name == "perceive_scene"]
        if len(history) in (0, 3):
            return Call.of("perceive_scene")
        if len(history) == 1:
            named = [s for s in graphs[0].named if s.name and s.name in question.text]
            # A place means one thing; a name may fit several.
            return Call.of("find_object", {"description": named[0].place}) if named else None
        if len(history) == 2:
            return Call.of("grasp_and_remove", {"object_id": read_handle(history[1].result.text)})
        new = {s.name for s in graphs[1].named} - {s.name for s in graphs[0].named}
        shown = [letter for letter, text in question.options if text in new]
        # Where nothing came to light, "None of the above" would be a guess.
        return Call.of("answer_question", {"choice": (*shown, "E")[0]}) if new else None
