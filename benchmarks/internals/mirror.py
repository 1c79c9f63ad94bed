"""Compare's tasks with their other worlds.

`python benchmarks/internals/mirror.py compare.json mirror.json`. Measures internals, not the public
API.

The same scenes, but for paint that doesn't show, answered the other way. Whatever
`probe suite shortcuts compare.json mirror.json` finds beyond one half comes from traces of that
paint: all else is there once with each answer. Two tasks of a pair are predicted in one round.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Annotated

import tyro

from probe.api.resources import everything
from probe.generation.twin_worlds import other_world
from probe.tasks.suite import freeze
from probe.tasks.suite_file import find_suite, write_suite
from probe.tasks.task import PAIR, Task


def main(
    suite: Annotated[str, tyro.conf.Positional], out: Annotated[Path, tyro.conf.Positional]
) -> None:
    """Write the other worlds of a suite's Compare tasks.

    Args:
        suite: Name, or a file that `probe suite build` wrote.
        out: File for them.
    """
    mirrored = tuple(
        mirror(task) for task in find_suite(suite).tasks if task.question_type == "compare"
    )
    write_suite(out, freeze("mirror", mirrored, everything()))
    print(f"{len(mirrored)} tasks are in {out}.")


def mirror(task: Task) -> Task:
    """A Compare task with both marked things' paint twins in their places."""
    twins = task.certificate.candidates[len(PAIR) :]
    paints = {mark.instance: twin for mark, twin in zip(task.marks, twins, strict=True)}
    return replace(
        task,
        id=f"{task.id}-mirrored",
        scene=other_world(task.scene, paints),
        answer=PAIR[task.answer == PAIR[0]],
    )


if __name__ == "__main__":
    tyro.cli(main)
