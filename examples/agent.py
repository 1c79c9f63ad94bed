"""Write an agent and let it be scored on a task: `python examples/agent.py --help`."""

from __future__ import annotations

from collections.abc import Sequence
from importlib import resources
from pathlib import Path

import tyro

from probe.agents.reading import read_graph, read_handle
from probe.assets.tables import load_table
from probe.cli.surroundings import library
from probe.episodes.files import write_records
from probe.episodes.play import play, score
from probe.episodes.turns import Call, Question, Turn
from probe.render.renderer import Renderer
from probe.tasks.suite_file import read_suite, write_suite


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


def main(out: Path = Path("outputs/examples/agent")) -> None:
    """Run the agent on the demo suite's first task, grade it and keep the record."""
    with resources.as_file(resources.files("probe.tasks") / "data/demo.json") as path:
        suite = read_suite(path)
    task, things = suite.tasks[0], library("procedural")
    with Renderer() as renderer:
        table = load_table(task.scene.table, None)
        record = play(task, LiftWhatIsNamed(), "lift-what-is-named", things, table, renderer)
        result = score(task, record, renderer)
    # With both files in one folder, `probe report FOLDER` draws the episode.
    write_suite(out / "suite.json", suite)
    write_records(out / "records.jsonl", [record])
    for step in record.steps:
        print(f"{step.call.name} {step.call.arguments}: {step.text.splitlines()[0]}")
    print(f"{result.outcome}, {record.manipulations} manipulation(s); see `probe report {out}`")


if __name__ == "__main__":
    tyro.cli(main)
