"""Tables of frozen tasks: what their tools take for an answer."""

from dataclasses import replace

import pytest

from probe.api.resources import everything
from probe.episodes.circumstances import Circumstances
from probe.episodes.conditions import Conditions
from probe.episodes.play import open_episode, play, replay_afresh
from probe.episodes.replay import differences
from probe.episodes.turns import Call
from probe.render.renderer import Renderer
from probe.runs.plan import Job, RunOrder
from probe.runs.viewpoints import circumstances_of
from probe.tasks.suite_file import packaged_suite

pytestmark = pytest.mark.slow


@pytest.fixture(scope="module")
def things():
    with Renderer() as renderer:
        yield everything(), renderer


def task_of(question_type: str):
    return next(it for it in packaged_suite("v1").tasks if it.question_type == question_type)


class Pointless:
    """Answers until it is heard, and never points."""

    def act(self, question, history):
        return Call.of("answer_question", {"choice": "A"})


def test_find_asks_for_its_point_and_is_replayed_with_that(things):
    task, (library, renderer) = task_of("find"), things
    record = play(task, Pointless(), "pointless", library, renderer)
    assert [step.status for step in record.steps] == ["malformed", "done"]
    assert "point at something" in record.steps[0].text
    assert differences(record, replay_afresh(task, record, library, renderer)) == []


def test_another_renderer_than_the_one_that_is_said_draws_nothing(things):
    task, (library, renderer) = task_of("find"), things
    blender = Circumstances(viewpoint=replace(task.viewpoint, renderer="blender"))
    with pytest.raises(ValueError, match="blender is to draw"):
        open_episode(task, "anna", library, renderer, blender)


def test_the_record_of_an_open_episode_tells_its_conditions(things):
    task, (library, renderer) = task_of("size"), things
    order = RunOrder("anna", conditions=Conditions(camera="moved", renderer="filament"))
    circumstances = circumstances_of(order, Job(task, 2), None)
    episode = open_episode(task, "anna", library, renderer, circumstances)
    assert episode.record.circumstances == circumstances


def test_size_has_two_letters(things):
    episode = open_episode(task_of("size"), "somebody", *things)
    refused = episode.step(Call.of("answer_question", {"choice": "E"})).result
    assert (refused.status, refused.ended) == ("malformed", False)
    assert "Its options are A and B." in refused.text
    assert episode.step(Call.of("answer_question", {"choice": "A"})).result.ended
