"""Call the five tools by hand on one frozen task: `python examples/play.py --help`."""

from __future__ import annotations

from pathlib import Path

import tyro
from PIL import Image

import probe

TASK = "beneath-8af85510"
"""A task of the demo suite: what did the green mug cover?"""


def main(out: Path = Path("outputs/examples/play")) -> None:
    """Lift the cover, look what it hid, and answer.

    Args:
        out: Folder for the picture that each call brought.
    """
    task = probe.load_suite("demo")[TASK]
    out.mkdir(parents=True, exist_ok=True)
    print(task.question, *(f"{o.letter}: {o.text}" for o in task.options), sep="\n")
    with probe.open_episode(task, probe.open_library()) as episode:

        def call(tool: str, **arguments: object) -> None:
            result = episode.step(tool, **arguments)
            given = ", ".join(f"{key}={value!r}" for key, value in arguments.items())
            print(f"\n> {tool}({given})\n{result.text}")
            if result.picture is not None:
                number = len(episode.record.steps)
                Image.fromarray(result.picture).save(out / f"{number}-{tool}.png")

        call("perceive_scene")
        # The cover can be named because it is visible; nothing can name what is under it.
        call("find_object", description=task.subject)
        call("grasp_and_remove", object_id="object_10")
        # What lay under the mug shows now and has an id of its own.
        call("find_object", description="black tape")
        call("answer_question", choice="C")
        # The tools accept any letter; only the task knows which one is right.
        print(f"\nThe right answer is {task.answer}; this one is {episode.score().outcome}.")


if __name__ == "__main__":
    tyro.cli(main)
