"""A suite's tasks with each of their answers: does anything that shows tell them apart?

`python benchmarks/internals/worlds.py v2.json outputs/worlds.json`, then
`probe suite shortcuts outputs/worlds.json`. Measures internals, not the public API.

The generator lays each of five candidates in the hidden place, and keeps a scene only if all five
pass. Here a task is made from its seed again, and all five scenes are written down with its
question and options, so that each of its letters is right once. What is alike in the five gives one
fifth, up to ties, whoever learns from it; whatever is found beyond that comes from what differs
between them. The five stand in one block, and are predicted in one round.

Types that don't lay all candidates (Compare, Count, Size; Find where nothing is wholly hidden) have
no worlds. Each task is a file in a folder beside the output, so that the same command goes on where
it was stopped.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Annotated

import tyro
from rich.progress import track

from probe.api.resources import opener, tables_for
from probe.assets.library import Library
from probe.generation.attempt import Attempt
from probe.generation.build import without_notes
from probe.generation.generate import make
from probe.generation.result import TaskCandidate
from probe.render.renderer import Renderer
from probe.tasks.suite import freeze
from probe.tasks.suite_file import digest_of, find_suite, read_suite, write_suite
from probe.tasks.task import LETTERS, NONE_OF_THE_ABOVE, QuestionType, Task


def main(
    suite: Annotated[str, tyro.conf.Positional],
    out: Annotated[Path, tyro.conf.Positional],
    types: tuple[QuestionType, ...] = (),
) -> None:
    """Write the worlds of a public suite's tasks.

    Args:
        suite: Name, or a file that `probe suite build` wrote.
        out: File for them.
        types: Only tasks of these types; by default all.
    """
    frozen = find_suite(suite)
    pool = frozen.pool or "procedural"
    library, tables = opener(pool)(), tables_for(pool)
    parts = out.with_suffix(".parts")
    parts.mkdir(parents=True, exist_ok=True)
    tasks = [it for it in frozen.tasks if not types or it.question_type in types]
    found = list[Task]()
    with Renderer(library.light_cache) as renderer:
        for task in track(tasks, "Laying"):
            part = parts / f"{task.id}.json"
            if not part.exists():
                made = make(Attempt.of_task(task), library, renderer, tables)
                write_suite(part, freeze(task.id, worlds_of(task, made, library), library))
            found += read_suite(part).tasks
    write_suite(out, freeze(out.stem, tuple(found), library))
    print(f"{len(found)} worlds of {len(tasks)} tasks are in {out}.")


def worlds_of(task: Task, made: object, library: Library) -> tuple[Task, ...]:
    """A task with each of its candidates in the hidden place; none where not all were laid.

    Args:
        task: Frozen.
        made: What its seed gives now.
        library: Has its objects.

    Raises:
        SystemExit: Its seed gives another task.
    """
    if not isinstance(made, TaskCandidate) or digest_of(made.task) != digest_of(
        without_notes(task)
    ):
        raise SystemExit(f"{task.id} isn't made from its seed any more: {made}")
    texts = [option.text for option in task.options]
    names = [library[id].name for id in task.certificate.candidates[: len(made.twins)]]
    return tuple(
        replace(
            task,
            id=f"{task.id}-{number}",
            scene=scene,
            answer=LETTERS[texts.index(name if name in texts else NONE_OF_THE_ABOVE)],
        )
        for number, (name, scene) in enumerate(zip(names, made.twins, strict=True))
    )


if __name__ == "__main__":
    tyro.cli(main)
