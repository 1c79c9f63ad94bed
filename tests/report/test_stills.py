import io
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from probe.assets.library import open_library
from probe.errors import BadData
from probe.report.scene_renderer import SceneRenderer
from probe.report.stills import Still, develop, file_of, stills_of
from probe.scene.viewpoint import Viewpoint
from probe.scene.visibility import Visibility
from probe.tasks.task import Mark
from run_folders import DEMO, episode

TASK = DEMO.tasks[0]
MARKS = (Mark("A", 1, (300, 400)),)
STILL = Still(TASK.scene)


def nowhere() -> SceneRenderer:
    """A darkroom that can't draw."""

    def closed():
        raise AssertionError("nothing should be drawn")

    return SceneRenderer(DEMO, closed)


def test_an_agents_pictures_are_marked_at_the_start_and_outlined_where_it_found_something():
    marked = replace(TASK, marks=MARKS)
    start, found, *rest = stills_of(marked, episode(TASK), Path())
    assert (start.marks, start.outline) == (MARKS, None)
    assert (found.marks, found.outline) == ((), (512, 256))
    assert {still.outline for still in rest} == {None}


def test_a_file_is_named_by_what_it_shows():
    name = file_of(STILL, DEMO.objects)
    assert name == file_of(Still(replace(TASK.scene)), DEMO.objects)
    moved = replace(TASK.scene, objects=TASK.scene.objects[::-1])
    other = {id: (1.0,) for id in DEMO.objects}
    names = {
        name,
        file_of(Still(moved), DEMO.objects),
        file_of(Still(TASK.scene, outline=(1, 2)), DEMO.objects),
        file_of(Still(TASK.scene, marks=MARKS), DEMO.objects),
        file_of(STILL, other),
    }
    assert len(names) == 5
    unshown = {**DEMO.objects, "proc_elsewhere": (1.0,)}
    assert file_of(STILL, unshown) == name


def test_what_draws_a_picture_is_part_of_its_name():
    record = episode(TASK)
    own, other = (stills_of(TASK, record, Path(), name) for name in ("own", "blender"))
    assert {still.viewpoint.renderer for still in own} == {"filament"}
    assert {still.viewpoint.renderer for still in other} == {"blender"}
    names, others = ({file_of(still, DEMO.objects) for still in some} for some in (own, other))
    assert names.isdisjoint(others) and len(names) == len(others)


def test_a_picture_that_another_folder_has_is_taken_over(tmp_path):
    (tmp_path / "b").mkdir()
    (tmp_path / "b" / "x.webp").write_bytes(b"drawn before")
    develop(STILL, TASK, tmp_path / "c" / "x.webp", nowhere(), [tmp_path / "a", tmp_path / "b"])
    assert (tmp_path / "c" / "x.webp").read_bytes() == b"drawn before"


def test_a_picture_that_cannot_be_read_is_named(tmp_path):
    (tmp_path / "b" / "x.webp").mkdir(parents=True)
    with pytest.raises(BadData, match="x.webp: is a folder, not a file. Delete it; it is"):
        develop(STILL, TASK, tmp_path / "x.webp", nowhere(), [tmp_path / "b"])


def test_grades_that_hang_on_no_view_need_no_drawing():
    count = next(task for task in DEMO.tasks if task.question_type == "count")
    assert nowhere().score(count, episode(count)).correct
    find = next(task for task in DEMO.tasks if task.question_type == "find")
    assert not nowhere().score(find, episode(find, right=False)).correct


@pytest.mark.slow
def test_the_thing_found_is_outlined_in_its_picture(tmp_path, cache):
    seen = TASK.certificate.visibility
    clear = max(seen, key=lambda number: seen[number].visible_px)
    assert isinstance(seen[clear], Visibility)
    with SceneRenderer(DEMO, lambda: open_library("procedural", None, cache)) as room:
        labels = room.frame(TASK, TASK.scene, Viewpoint(), rgb=False).labels
        assert labels is not None
        v, u = (int(n) for n in np.argwhere(labels == clear)[0])
        plain, found = (
            drawn(tmp_path / name, room, still)
            for name, still in (("a", STILL), ("b", Still(TASK.scene, outline=(u, v))))
        )
    assert plain.shape == found.shape == (1024, 1024, 3)
    changed = np.abs(plain.astype(int) - found).max(axis=2) > 60
    around = np.pad(labels == clear, 16)
    near = np.any(
        [np.roll(around, (i, j), (0, 1)) for i in range(-16, 17) for j in range(-16, 17)], 0
    )
    assert changed.sum() > 100
    # WebP smears over neighbouring pixels, so the outline itself is looked for nearby.
    assert (changed & ~near[16:-16, 16:-16]).mean() < 0.001


def drawn(path: Path, room: SceneRenderer, still: Still):
    develop(still, TASK, path, room, [])
    return np.asarray(Image.open(io.BytesIO(path.read_bytes())))
