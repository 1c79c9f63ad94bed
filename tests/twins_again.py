"""Generated tasks with twins, looked at again from pictures, names and sizes alone."""

from __future__ import annotations

from probe.assets.library import Library
from probe.assets.tables import load_table
from probe.generation.result import TaskCandidate
from probe.render.photograph import load_scene, measure
from probe.render.renderer import Renderer
from probe.scene.cameras import View
from probe.scene.scene import Scene
from probe.tasks.task import Task

TABLES = ("oak_planks",)


def shares(
    scene: Scene, library: Library, renderer: Renderer, view: View = "top"
) -> dict[int, float]:
    """Visible share of every object, by instance."""
    load_scene(renderer, scene, library, load_table(TABLES[0], None))
    seen = measure(renderer, scene, scene.setup.camera(view))
    return {number: it.visible_px / it.alone_px for number, it in seen.items()}


def check_words(task: Task, library: Library) -> None:
    """The question names what it is about and not the answer; one option at most is there."""
    names = [library[placed.object_id].name for placed in task.scene.objects]
    true_name = library[task.scene[task.targets[0]].object_id].name
    assert true_name not in task.question
    assert {option.text for option in task.options} & set(names) <= {true_name}
    texts = {option.letter: option.text for option in task.options}
    assert texts[task.answer] == (true_name if task.answer != "E" else "None of the above")


def check_turns(made: TaskCandidate) -> None:
    """Each candidate had its turn."""
    drawn, (target,) = made.task.certificate.candidates, made.task.targets
    assert [twin[target].object_id for twin in made.twins] == list(drawn)
    assert made.task.scene in made.twins


def check_candidates(made: TaskCandidate, library: Library) -> None:
    """Each had its turn, and length, width and height tell nothing."""
    check_turns(made)
    drawn = made.task.certificate.candidates
    sizes = [(*sorted(library[it].size[:2]), library[it].size[2]) for it in drawn]
    for sides in zip(*sizes, strict=True):
        assert max(sides) <= 1.1 * min(sides) + 1e-9
