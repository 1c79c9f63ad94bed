"""Call the five tools by hand on one frozen task: `python examples/play.py --help`."""

from __future__ import annotations

from importlib import resources
from pathlib import Path

import tyro

from probe.assets.tables import load_table
from probe.cli.resources import library
from probe.episodes.play import set_table
from probe.files import write_picture
from probe.render.renderer import Renderer
from probe.tasks.suite_file import read_suite

TASK = "beneath-8af85510"
"""A task of the demo suite: what did the green mug cover?"""


def main(out: Path = Path("outputs/examples/play")) -> None:
    """Lift the cover, look what it hid, and answer.

    Args:
        out: Folder for the picture that each call brought.
    """
    with resources.as_file(resources.files("probe.tasks") / "data/demo.json") as path:
        tasks = {task.id: task for task in read_suite(path).tasks}
    task, things = tasks[TASK], library("procedural")
    print(task.question, *(f"{o.letter}: {o.text}" for o in task.options), sep="\n")
    with Renderer() as renderer:
        table = load_table(task.scene.table, None)
        tools, _ = set_table(task, things, table, renderer, pictures=True)

        def call(name: str, **arguments: object) -> str:
            result = tools.call(name, arguments)
            given = ", ".join(f"{key}={value!r}" for key, value in arguments.items())
            print(f"\n> {name}({given})\n{result.text}")
            if result.picture is not None:
                write_picture(out / f"{tools.turns}-{name}.png", result.picture)
            return result.text

        call("perceive_scene")
        # The cover can be named since it shows; what is under it can't, whoever asks.
        call("find_object", description=task.subject)
        call("grasp_and_remove", object_id="object_1")
        # A new handle for every look: object_1 went into the basket.
        call("find_object", description="black tape")
        call("answer_question", choice="C")
    # Only we know the truth; the tools accept any letter without a word about it.
    print(f"\nRight is {task.answer}.")


if __name__ == "__main__":
    tyro.cli(main)
