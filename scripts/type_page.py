"""Write docs/get-started/what-is-asked.md: a task of each question type, before and after.

A test sees that the page still says what its tasks say. `--draw-all` draws their pictures as well.
"""

from __future__ import annotations

from pathlib import Path

import tyro
from beside import beside, write_picture

from probe.api.resources import library
from probe.assets.library import Pool
from probe.episodes.oracle_view import oracle_view
from probe.render.renderer import Renderer
from probe.tasks.suite_file import packaged_suite, read_suite
from probe.tasks.task import Task

ROOT = Path(__file__).parents[1]
PAGE = ROOT / "docs/get-started/what-is-asked.md"
STEPS = ("nested", "decoys", "exact", "ranked", "relation", "budgeted", "memory")
"""Types that `tour` lacks; a test of each has a frozen task."""

SIDE_PX = 440
WHAT = {
    "beneath": "What lay under a cover?",
    "behind": "What did something tall hide from the front camera?",
    "compare": "Which of two marked, partly covered things is darker, or of a given colour?",
    "count": "How many of a kind are there, those under things included?",
    "find": "Which of these is here, and where?",
    "reduce": "What was hidden by the things that are to be removed, one to five of them?",
    "size": "Which of two marked, partly covered things is larger, or longer?",
    "nested": "What lies under the thing under the cover?",
    "decoys": "Which of several things lies under any of three covers that look alike?",
    "exact": "What comes to light, if nothing else may leave or move far?",
    "ranked": "Which of three hidden things is the longest, the second, the shortest?",
    "relation": "What lies under the cover next to the one that hides a thing?",
    "budgeted": "Which of five covers is worth one of three tries?",
    "memory": "What was where, once the table has been changed as it was asked?",
}
"""In few words."""

INTRO = """# What is asked

One task of each question type. On the left is the first picture, as an agent gets it. On the right
is the same table without what hides the evidence: no agent is shown that, it has to move things.
[Question types](../reference/rules.md) has the rules, [types with several
steps](../reference/several-steps.md) those of the last seven.

Four of five options are objects or numbers, and the fifth is "none of the above"; Compare and Size
have two. The first seven tasks are those of the suite `tour`, which `make demo` plays. Those of the
last seven types are from our tests. The suite `v2` has 22 tasks of each type, but 20 of Compare."""


def tasks() -> list[tuple[Task, Pool]]:
    """A task of each type, with the pool of its objects."""
    suites = [read_suite(ROOT / "tests/question_types" / name / "tasks.json") for name in STEPS]
    first: dict[str, tuple[Task, Pool]] = {}
    for suite in (packaged_suite("tour"), *suites):
        for task in suite:
            first.setdefault(task.question_type, (task, suite.pool or "procedural"))
    return [first[name] for name in WHAT]


def page() -> str:
    """The page."""
    return "\n\n".join([INTRO, *(_section(task) for task, _ in tasks())]) + "\n"


def _section(task: Task) -> str:
    name = task.question_type
    right = next(option for option in task.options if option.letter == task.answer)
    options = ", ".join(f"{option.letter}: {option.text}" for option in task.options)
    about = f"{name.capitalize()}: the table at the start, and without what hides the answer."
    return "\n\n".join(
        [
            f"## {name.capitalize()}",
            WHAT[name],
            f"![{about}](../pictures/{picture_of(task)})",
            f"> {task.question}",
            f"{options}. Right is **{right.letter}** ({right.text}).",
        ]
    )


def picture_of(task: Task) -> str:
    """Its file, named after the task: one that changes needs another picture."""
    return f"type_{task.id}.jpg"


def draw(task: Task, pool: Pool, renderer: Renderer) -> None:
    """Write a task's two pictures, side by side."""
    seen = oracle_view(task, library(pool), renderer)
    first, revealed = (frame.rgb for frame in seen.frames)
    assert first is not None and revealed is not None
    write_picture(picture_of(task), beside(first, revealed, SIDE_PX), SIDE_PX)


def main(*, draw_all: bool = False) -> None:
    """Write the page anew.

    Args:
        draw_all: Draw the pictures as well.
    """
    PAGE.write_text(page(), "utf-8")
    if draw_all:
        with Renderer() as renderer:
            for task, pool in tasks():
                draw(task, pool, renderer)


if __name__ == "__main__":
    tyro.cli(main)
