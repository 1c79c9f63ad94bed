"""One task of each type, checked by looking at its scene anew."""

from __future__ import annotations

import itertools

import numpy as np
import pytest

from probe.assets.library import Library
from probe.assets.tables import load_table
from probe.certify.generate import generate
from probe.certify.plan import ATTEMPTS, plan
from probe.certify.result import Candidate
from probe.render.photograph import load_scene, measure
from probe.render.renderer import Renderer
from probe.scene.scene import Scene
from probe.tasks.task import QuestionKind, Task

TABLES = ("oak_planks",)
pytestmark = pytest.mark.slow


def first_kept(kind: QuestionKind, episode: int, library: Library, renderer: Renderer):
    """The first attempt of an episode that is kept."""
    for seed in itertools.count(episode * ATTEMPTS):
        result = generate(kind, seed, library, renderer, TABLES)
        if isinstance(result, Candidate):
            return result
    raise AssertionError


def shares(scene: Scene, library: Library, renderer: Renderer) -> dict[int, tuple[float, int]]:
    """Visible share and pixels of every object."""
    load_scene(renderer, scene, library, load_table(TABLES[0], None))
    seen = measure(renderer, scene)
    return {number: (v.visible_px / v.alone_px, v.visible_px) for number, v in seen.items()}


def names_on_table(task: Task, library: Library) -> list[str]:
    return [library[placed.object_id].name for placed in task.scene.objects]


def check_options(task: Task, true_text: str) -> None:
    texts = {option.letter: option.text for option in task.options}
    assert texts["E"] == "None of the above"
    assert (
        (texts[task.answer] == true_text)
        if task.answer != "E"
        else (true_text not in texts.values())
    )


def check_certificate(task: Task, measured: dict[int, tuple[float, int]]) -> None:
    stated = task.certificate.visibility
    assert {n: v.visible_px for n, v in stated.items()} == {
        n: px for n, (_, px) in measured.items()
    }


def test_beneath(library: Library, renderer: Renderer):
    candidate = first_kept("beneath", 2, library, renderer)
    task = candidate.task
    (target,), cover = task.targets, task.cover
    assert cover is not None
    names = names_on_table(task, library)
    assert len(names) == len(set(names)) == 15
    true_name = library[task.scene[target].object_id].name
    assert task.subject == library[task.scene[cover].object_id].name
    assert task.subject in task.question and true_name not in task.question
    check_options(task, true_name)
    assert {o.text for o in task.options} & set(names) <= {true_name}
    assert len(candidate.twins) == 5 and task.scene in candidate.twins
    for twin, object_id in zip(candidate.twins, task.certificate.candidates, strict=True):
        assert twin[target].object_id == object_id
        before = shares(twin, library, renderer)
        after = shares(twin.without(cover), library, renderer)
        assert before[target][0] <= 0.05 and before[target][1] < 200
        assert before[cover][0] >= 0.30
        assert after[target][0] >= 0.60
        gains = [after[n][0] - before[n][0] for n in after if n != target]
        assert max(gains) <= 0.20
    check_certificate(task, shares(task.scene, library, renderer))


@pytest.mark.parametrize("episode", [0, 1])
def test_count(library: Library, renderer: Renderer, episode):
    task = first_kept("count", episode, library, renderer).task
    wanted = plan("count", episode * ATTEMPTS)
    assert 12 <= len(task.scene.objects) <= 15
    names = names_on_table(task, library)
    number = names.count(task.subject)
    assert number == wanted.visible + wanted.hidden == len(task.targets)
    others = [name for name in names if name != task.subject]
    assert len(others) == len(set(others))
    check_options(task, str(number))
    measured = shares(task.scene, library, renderer)
    mine = sorted(measured[n][0] for n in task.targets)
    assert all(share <= 0.05 for share in mine[: wanted.hidden])
    assert all(share >= 0.50 for share in mine[wanted.hidden :])
    check_certificate(task, measured)


def find_episode(*, partly: bool) -> int:
    return next(e for e in itertools.count() if plan("find", e * ATTEMPTS).partly is partly)


@pytest.mark.parametrize("partly", [False, True])
def test_find(library: Library, renderer: Renderer, partly):
    candidate = first_kept("find", find_episode(partly=partly), library, renderer)
    task = candidate.task
    (target,) = task.targets
    true_name = library[task.scene[target].object_id].name
    names = names_on_table(task, library)
    assert len(names) == len(set(names)) == 15
    check_options(task, true_name)
    assert {o.text for o in task.options} & set(names) <= {true_name}
    assert len(candidate.twins) == (0 if partly else 5)
    measured = shares(task.scene, library, renderer)
    low, high = (0.05, 0.25) if partly else (0.0, 0.05)
    assert low <= measured[target][0] <= high
    check_certificate(task, measured)


def test_the_same_seed_gives_the_same_candidate(library: Library, renderer: Renderer):
    seed = first_kept("count", 0, library, renderer).task.seed
    once = generate("count", seed, library, renderer, TABLES)
    assert isinstance(once, Candidate)
    with Renderer() as another:
        assert generate("count", seed, library, another, TABLES) == once
    positions = np.array([placed.pose.position for placed in once.task.scene.objects])
    assert np.abs(positions[:, :2]).max() < 0.29
