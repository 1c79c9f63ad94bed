"""The teacher on a real table: its records are a model's, and their pictures are the tools'."""

from __future__ import annotations

from dataclasses import replace
from functools import partial

import pytest

from lessons import BY_KIND
from probe.assets.library import open_library
from probe.episodes.files import line_of, record_of
from probe.episodes.play import open_episode
from probe.render.renderer import Renderer
from probe.report.scene_renderer import SceneRenderer
from probe.runs.plan import Job, RunOrder
from probe.tasks.suite import part
from probe.train.collect.teacher import TEACHER, TeacherWorker, teacher_for
from probe.train.dataset.showing import OtherPerception, shown
from probe.transcripts.messages import messages
from probe.transcripts.pictures import jpeg
from run_folders import DEMO

pytestmark = pytest.mark.slow

TASK = BY_KIND["beneath"]


@pytest.fixture(scope="module")
def library(cache):
    return partial(open_library, "procedural", None, cache)


@pytest.fixture(scope="module")
def taught(library):
    """The teacher's record with tools, in thousandths."""
    order = RunOrder(TEACHER, setting="agentic", points="0-1000")
    with Renderer() as renderer:
        place = TeacherWorker(order, library, teacher_for("0-1000"))
        return place.played(Job(TASK, 0), library(), renderer)


def test_it_says_something_with_each_call_and_counts_in_whole_thousandths(taught):
    assert record_of(line_of(taught)) == taught
    assert taught.end == "answered" and taught.participation.setting == "agentic"
    assert all(step.call.words for step in taught.steps)
    told = messages(taught, [b""], [None] * len(taught.steps))
    places = [call.arguments for it in told for _, call in it.calls if call.name == "find_object"]
    assert places and all("." not in place for place in places)


def test_its_pictures_are_those_that_the_tools_gave(taught, library):
    things = library()
    with Renderer() as renderer:
        episode = open_episode(TASK, TEACHER, things, renderer)
        first = episode.record.question.picture
        came = [episode.step(step.call).result.picture for step in taught.steps]
    with SceneRenderer(part(DEMO, TASK), library) as scene_renderer:
        drawn = shown(TASK, taught, scene_renderer)
        with pytest.raises(OtherPerception, match="Collect with --pointer oracle"):
            seat = replace(taught.participation, setting="agentic, pointer self")
            shown(TASK, replace(taught, participation=seat), scene_renderer)
        small = shown(TASK, taught, scene_renderer, 64)
    assert first is not None and drawn.first == (jpeg(first),)
    assert drawn.later == tuple(None if it is None else jpeg(it) for it in came)
    assert len(small.all) == len(drawn.all) and len(small.all[0]) < len(drawn.all[0]) / 20


def test_without_tools_it_is_silent_where_the_evidence_is_hidden(library):
    order = RunOrder(TEACHER, setting="direct")
    with Renderer() as renderer:
        place = TeacherWorker(order, library, teacher_for("pixels"))
        record = place.played(Job(TASK, 0), library(), renderer)
    assert (record.end, record.answer, record.steps, record.setting) == (
        "stopped",
        None,
        (),
        "direct",
    )
