"""A suite's tasks with each of their answers: does anything that shows tell them apart?

`python benchmarks/internals/worlds.py v2 outputs/worlds.json`. Measures internals, not the public
API.

The generator lays each of five candidates in the hidden place, and keeps a scene only if all five
pass. Here a task is made from its seed again, and all five scenes are written down with its
question and options, so that each of its letters is right once. What is alike in the five gives one
fifth, up to ties, whoever learns from it; whatever is found beyond that comes from what differs
between them. The rules and classifiers of `probe suite shortcuts` are tried on them. Classifiers
predict the scenes of five tasks in one round; the five scenes of each are even in letters.

Types that don't lay all candidates (Compare, Count, Size; Find where nothing is wholly hidden) have
no worlds. Each task is a file in a folder beside the output, so that the same command goes on where
it was stopped.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Annotated

import tyro
from rich.progress import track

from probe.api.resources import cache_folder, everything, opener, tables_for
from probe.assets.library import Library
from probe.files import write_text
from probe.generation.result import TaskCandidate
from probe.render.renderer import Renderer
from probe.scene.scene import Scene
from probe.shortcuts.investigation import investigate
from probe.shortcuts.looks import examples_of
from probe.shortcuts.sample import CatalogueFacts, LabelledSample
from probe.shortcuts.table import markdown
from probe.tasks.suite import Suite, freeze
from probe.tasks.suite_file import find_suite, read_suite, write_suite
from probe.tasks.task import NONE_OF_THE_ABOVE, QuestionType, Task
from probe.verification.check import rebuilt

_ROUND = 5
"""Tasks whose scenes are predicted at once."""


def main(
    suite: Annotated[str, tyro.conf.Positional],
    out: Annotated[Path, tyro.conf.Positional],
    types: tuple[QuestionType, ...] = (),
) -> None:
    """Write the worlds of a public suite's tasks, and try what tells them apart.

    Args:
        suite: Name, or a file that `probe suite build` wrote.
        out: File for them; what rules and classifiers reach is beside it, with the ending .md.
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
                made = rebuilt(task, library, renderer, tables)
                if isinstance(made, str):
                    raise SystemExit(f"{task.id} can't be made from its seed again: {made}")
                write_suite(part, freeze(task.id, worlds_of(task, made, library), library))
            found += read_suite(part).tasks
    worlds = freeze(out.stem, tuple(found), library)
    write_suite(out, worlds)
    print(f"{len(found)} worlds of {len(tasks)} tasks are in {out}.")
    things = everything()
    looking = examples_of([worlds], things, cache_folder())
    examples = in_rounds(list(track(looking, "Looking", total=len(found))), worlds)
    findings = investigate(examples, CatalogueFacts(things.specs))
    write_text(out.with_suffix(".md"), told := markdown(findings))
    print(told)


def in_rounds(examples: Sequence[LabelledSample], worlds: Suite) -> list[LabelledSample]:
    """The examples, those of some tasks in a block; `worlds` tells of which task a scene is."""
    seeds = {task.id: (task.question_type, task.seed) for task in worlds.tasks}
    number = {seed: place for place, seed in enumerate(dict.fromkeys(seeds.values()))}
    return [replace(it, block=number[seeds[it.task]] // _ROUND) for it in examples]


def worlds_of(task: Task, made: TaskCandidate, library: Library) -> tuple[Task, ...]:
    """A task with each of its candidates in the hidden place; none where not all were laid."""
    letters = {option.text: option.letter for option in task.options}
    ids = task.certificate.candidates[: len(made.twins)]
    return tuple(
        replace(
            task,
            id=f"{task.id}-{number}",
            scene=scene,
            targets=_targets(task, scene, candidate),
            answer=letters[
                name if (name := library[candidate].name) in letters else NONE_OF_THE_ABOVE
            ],
        )
        for number, (candidate, scene) in enumerate(zip(ids, made.twins, strict=True))
    )


def _targets(task: Task, scene: Scene, candidate: str) -> tuple[int, ...]:
    """What is asked about where a candidate is the answer, and what else decides there."""
    before = {placed.instance for placed in task.scene.objects}
    here = [placed.instance for placed in scene.objects]
    named = [it.instance for it in scene.objects if it.object_id == candidate]
    kept = [it for it in task.targets if it in here and it not in named]
    new = [it for it in here if it not in before and it not in named]
    found = (*named[:1], *(kept + new)[: len(task.targets) - 1])
    if not named or len(found) < len(task.targets):
        raise SystemExit(f"{task.id}: {candidate} or what decides with it isn't on its table.")
    return found


if __name__ == "__main__":
    tyro.cli(main)
