"""A real table under each kind of perception."""

from importlib import resources

import pytest

from probe.assets.library import open_library
from probe.episodes.play import set_table
from probe.perception.choice import Perceiver, dialled, ideal, pointing
from probe.perception.dials import Dials
from probe.render.renderer import Renderer
from probe.tasks.suite_file import read_suite
from replies import Replies

pytestmark = pytest.mark.slow


@pytest.fixture(scope="module")
def tools_of(cache):
    with resources.as_file(resources.files("probe.tasks") / "data/demo.json") as path:
        task = next(t for t in read_suite(path).tasks if t.question_type == "beneath")
    things = open_library("procedural", None, cache)
    with Renderer() as renderer:

        def tools_of(perceiver: Perceiver):
            return task, *set_table(task, things, renderer, pictures=False, perceiver=perceiver)

        yield tools_of


def test_what_a_model_points_at_is_lifted(tools_of):
    task, tools, _ = tools_of(ideal)
    u, v = tools.call("find_object", {"description": task.subject}).point_px
    named = tools.call("perceive_scene", {}).text
    scene = Replies(["The cover, I think.", f'{{"point": [{u}, {v}]}}'])
    task, tools, station = tools_of(pointing(scene))
    cover = next(p for p in station.snapshot().objects if p.instance == task.cover)
    text = tools.call("find_object", {"description": task.subject}).text
    assert "object_1" in text and task.subject not in text and task.subject in named
    assert tools.call("grasp_and_remove", {"object_id": "object_1"}).status == "done"
    assert station.snapshot()[cover.instance].pose.position[0] < cover.pose.position[0] - 0.1


def test_dials_put_errors_into_the_same_table(tools_of):
    texts = [
        tools_of(perceiver)[1].call("perceive_scene", {}).text
        for perceiver in (
            ideal,
            dialled(Dials(), seed=7),
            dialled(Dials(missed=0.5), seed=7),
            dialled(Dials(missed=0.5), seed=7),
            dialled(Dials(missed=0.5), seed=7, run=1),
        )
    ]
    assert texts[0] == texts[1] != texts[2]
    assert texts[2] == texts[3] != texts[4]
