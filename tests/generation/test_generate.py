"""One task of each type, checked by looking at its scene anew."""

from __future__ import annotations

import itertools

import numpy as np
import pytest
import trimesh
from scipy import ndimage

from probe.assets.colour.difference import ciede2000
from probe.assets.colour.names import lab
from probe.assets.library import Library
from probe.assets.tables import load_table
from probe.generation.generate import generate
from probe.generation.plan import ATTEMPTS, plan
from probe.generation.result import TaskCandidate
from probe.generation.task_plan import CROSSED, MORE_CUES
from probe.generation.toppings import TOPPED
from probe.perception.colour_words import colour_words_in
from probe.question_types.count.generator import instances
from probe.question_types.find.generator import PARTLY_SEEN
from probe.question_types.reduce.generator import REMOVALS
from probe.question_types.size.cues import DEPTH
from probe.render.photograph import load_scene, measure, photograph
from probe.render.renderer import Renderer
from probe.scene.scene import Scene
from probe.scene.setup import UR5_TABLE
from probe.tasks.task import NONE_OF_THE_ABOVE, QuestionType, Task

TABLES = ("oak_planks",)
WORDS = {
    "black": (30, 30, 30),
    "brown": (110, 70, 40),
    "pink": (240, 150, 180),
    "red": (205, 45, 45),
}
"""sRGB of everyday words."""

pytestmark = pytest.mark.slow


def first_kept(question_type: QuestionType, episode: int, library: Library, renderer: Renderer):
    """The first attempt of an episode that is kept."""
    for seed in itertools.count(episode * ATTEMPTS):
        result = generate(question_type, seed, library, renderer, TABLES)
        if isinstance(result, TaskCandidate):
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
    bare = (e for e in itertools.count() if not TOPPED.of(plan("beneath", e * ATTEMPTS)))
    candidate = first_kept("beneath", next(bare), library, renderer)
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
    visible, hidden = instances(plan("count", episode * ATTEMPTS))
    assert 12 <= len(task.scene.objects) <= 15
    names = names_on_table(task, library)
    number = names.count(task.subject)
    assert number == visible + hidden == len(task.targets)
    others = [name for name in names if name != task.subject]
    assert len(others) == len(set(others))
    check_options(task, str(number))
    measured = shares(task.scene, library, renderer)
    mine = sorted(measured[n][0] for n in task.targets)
    assert all(share <= 0.05 for share in mine[:hidden])
    assert all(share >= 0.50 for share in mine[hidden:])
    check_certificate(task, measured)


def find_episode(*, partly: bool) -> int:
    return next(
        e for e in itertools.count() if PARTLY_SEEN.of(plan("find", e * ATTEMPTS)) is partly
    )


@pytest.mark.parametrize("partly", [False, True])
def test_find(library: Library, renderer: Renderer, partly):
    candidate = first_kept("find", find_episode(partly=partly), library, renderer)
    task = candidate.task
    (target,) = task.targets
    true_name = library[task.scene[target].object_id].name
    offered = {colour_words_in(o.text) for o in task.options if o.text != NONE_OF_THE_ABOVE}
    assert not partly or offered == {colour_words_in(true_name)}
    names = names_on_table(task, library)
    assert len(names) == len(set(names)) == 15
    check_options(task, true_name)
    assert {o.text for o in task.options} & set(names) <= {true_name}
    assert len(candidate.twins) == (0 if partly else 5)
    measured = shares(task.scene, library, renderer)
    low, high = (0.05, 0.25) if partly else (0.0, 0.05)
    assert low <= measured[target][0] <= high
    check_certificate(task, measured)


def test_reduce(library: Library, renderer: Renderer):
    episode = next(e for e in itertools.count() if REMOVALS.of(plan("reduce", e * ATTEMPTS)) == 2)
    candidate = first_kept("reduce", episode, library, renderer)
    task = candidate.task
    (target,) = task.targets
    true_name = library[task.scene[target].object_id].name
    assert 12 <= len(task.scene.objects) <= 15 and len(task.named) == 2
    names = [library[task.scene[number].object_id].name for number in task.named]
    assert all(name in task.question for name in names) and task.subject == ", ".join(names)
    check_options(task, true_name)
    assert {o.text for o in task.options} & set(names_on_table(task, library)) <= {true_name}
    for twin in candidate.twins:
        before = shares(twin, library, renderer)
        after = shares(twin.without(*task.named), library, renderer)
        assert before[target][0] <= 0.05 and before[target][1] < 200
        assert min(before[number][0] for number in task.named) >= 0.50
        assert after[target][0] >= 0.50
        risen = [after[n][0] for n in after if before[n][0] <= 0.05 and n != target]
        assert max(risen, default=0.0) <= 0.20
        for number in task.named:
            assert shares(twin.without(number), library, renderer)[target][0] <= 0.25
    check_certificate(task, shares(task.scene, library, renderer))


def check_marks(task: Task, measured: dict[int, tuple[float, int]], renderer: Renderer) -> None:
    """The two are partly hidden, and the marks lie well inside of what shows of them."""
    labels = renderer.draw(task.scene.objects, UR5_TABLE.camera(), rgb=False).labels
    assert labels is not None
    assert [mark.letter for mark in task.marks] == ["A", "B"]
    assert [option.text for option in task.options] == ["Object A", "Object B"]
    for mark in task.marks:
        assert 0.03 <= measured[mark.instance][0] <= 0.35
        u, v = mark.point
        assert (labels[v - 4 : v + 5, u - 4 : u + 5] == mark.instance).all()
        assert f"{mark.letter} at ({u}, {v})" in task.question


@pytest.mark.parametrize("episode", [5, 7])
def test_size(library: Library, renderer: Renderer, episode):
    wanted = plan("size", episode * ATTEMPTS)
    task = first_kept("size", episode, library, renderer).task
    measured = shares(task.scene, library, renderer)
    check_marks(task, measured, renderer)
    volumes, lengths = [], []
    for mark in task.marks:
        object_id = task.scene[mark.instance].object_id
        volumes.append(trimesh.convex.convex_hull(library.body(object_id).mesh.vertices).volume)
        lengths.append(max(library[object_id].size))
    large = int(np.argmax(lengths if wanted.form == "longer" else volumes))
    assert volumes[large] >= 2 * volumes[1 - large] or wanted.form == "longer"
    assert lengths[large] >= 1.25 * lengths[1 - large] or wanted.form != "longer"
    assert task.answer == "AB"[large if wanted.form != "smaller" else 1 - large] == wanted.letter
    numbers = [task.marks[large].instance, task.marks[1 - large].instance]
    # From 30 % on, perception would name it, and with its name comes its size.
    assert all(measured[number][0] < 0.30 for number in numbers)
    cues = (*CROSSED.of(wanted)[1:], MORE_CUES.of(wanted)[0])
    check_leads(task, numbers, cues, renderer)
    check_depth(task, numbers, DEPTH.of(wanted), library, renderer)
    check_certificate(task, measured)


def check_depth(task: Task, numbers: list[int], cues: tuple[bool, ...], library, renderer):
    """By heights that depth shows, the larger thing leads or lags as planned."""
    load_scene(renderer, task.scene, library, load_table(TABLES[0], None))
    frame = photograph(renderer, task.scene)
    bare = task.scene.without(
        *(o.instance for o in task.scene.objects if o.instance not in numbers)
    )
    alone = photograph(renderer, bare).labels
    assert frame.labels is not None and alone is not None
    v, u = np.mgrid[: frame.labels.shape[0], : frame.labels.shape[1]]
    pixels = np.column_stack([u.ravel(), v.ravel()]) + 0.5
    heights = frame.camera.lift(pixels, frame.depth.ravel())[:, 2].reshape(frame.labels.shape)
    tops, own = [], []
    for number in numbers:
        over = frame.labels[(alone == number) & (frame.labels != number)]
        cover = task.scene[int(np.bincount(over).argmax())]
        tops.append(cover.pose.apply(library.body(cover.object_id).mesh.vertices)[:, 2].max())
        own.append(heights[frame.labels == number].max())
    assert [large > small for large, small in (tops, own)] == [*cues]
    assert 1.05 <= max(tops) / min(tops) <= 1.8


def check_leads(task: Task, numbers: list[int], cues: tuple[bool, ...], renderer: Renderer):
    """By pixels, box and what adjoins, the larger thing leads or lags as planned, slightly."""
    labels = renderer.draw(task.scene.objects, UR5_TABLE.camera(), rgb=False).labels
    assert labels is not None
    corners = [np.argwhere(labels == number) for number in numbers]
    areas = [len(found) for found in corners]
    spans = [np.hypot(*(found.max(axis=0) - found.min(axis=0) + 1)) for found in corners]
    for (large, small), cue, most in zip((areas, spans), cues[:2], (2.0, 1.5), strict=True):
        assert (large > small) == cue
        assert 1.05 <= max(large / small, small / large) <= most
    away = [ndimage.distance_transform_cdt(labels != n, metric="taxicab") for n in numbers]
    bands = [labels[(steps > 0) & (steps <= 4)] for steps in away]
    large, small = (np.count_nonzero(band) / band.size for band in bands)
    assert (large > small) == cues[2] and 0.01 <= abs(large - small) <= 0.3


def check_patches(task: Task, right: int, cues: tuple[bool, ...], library, renderer: Renderer):
    """By the colours and pixels of the first picture, the right one leads or lags as planned."""
    load_scene(renderer, task.scene, library, load_table(TABLES[0], None))
    frame = photograph(renderer, task.scene)
    assert frame.rgb is not None
    masks = [frame.labels == mark.instance for mark in task.marks]
    word = lab(np.array([WORDS[task.subject]]))[0]
    off = [float(ciede2000(np.median(lab(frame.rgb[mask]), axis=0), word)) for mask in masks]
    assert (off[right] < off[1 - right]) == cues[0]
    assert (masks[right].sum() > masks[1 - right].sum()) == cues[1]


def test_compare(library: Library, renderer: Renderer):
    task = first_kept("compare", 1, library, renderer).task
    measured = shares(task.scene, library, renderer)
    check_marks(task, measured, renderer)
    right, wrong = "AB".index(task.answer), "BA".index(task.answer)
    specs = [library[task.scene[mark.instance].object_id] for mark in task.marks]
    assert task.form == "colour" and f" {task.subject}" in task.question
    assert specs[right].colours[0] == task.subject
    assert task.subject not in specs[wrong].colours
    assert min(v for k, v in task.certificate.measures.items() if k.startswith("apart")) >= 15
    assert all(measured[mark.instance][0] < 0.30 for mark in task.marks)
    wanted = plan("compare", ATTEMPTS)
    cues = CROSSED.of(wanted)[1:]
    assert (task.certificate.measures["patch_lead"] > 0) == cues[0]
    check_patches(task, right, cues, library, renderer)
    check_certificate(task, measured)


def test_the_same_seed_gives_the_same_candidate(library: Library, renderer: Renderer):
    seed = first_kept("count", 0, library, renderer).task.seed
    once = generate("count", seed, library, renderer, TABLES)
    assert isinstance(once, TaskCandidate)
    with Renderer() as another:
        assert generate("count", seed, library, another, TABLES) == once
    positions = np.array([placed.pose.position for placed in once.task.scene.objects])
    assert np.abs(positions[:, :2]).max() < 0.29
