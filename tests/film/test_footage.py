"""An episode is filmed as it was recorded, or not at all."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from probe.episodes.play import play
from probe.episodes.record import EpisodeRecord
from probe.episodes.replay import OtherTools
from probe.episodes.turns import Call
from probe.film.footage import CantFilm, take
from probe.tasks.suite_file import demo_suite

TASK = demo_suite().tasks[0]
CALLS = (
    Call.of("perceive_scene", words="Let me look."),
    Call.of("find_object", {"description": "clay flower pot"}),
    Call.of("answer_question", {"choice": "A"}),
)


class Fixed:
    """Makes the calls above."""

    def act(self, question, history):
        return CALLS[len(history)] if len(history) < len(CALLS) else None


@pytest.fixture(scope="module")
def record(library, renderer) -> EpisodeRecord:
    return play(TASK, Fixed(), "fixed", library, renderer)


def test_footage_tells_what_the_agent_did_read_and_saw(record, library, renderer):
    footage = take(TASK, record, library, renderer)
    assert [each.call for each in footage.calls] == list(CALLS)
    assert [each.result.text for each in footage.calls] == [step.text for step in record.steps]
    first, found = footage.question.picture, footage.calls[1].result.picture
    assert first is not None and found is not None
    # The picture that find_object gives has an outline.
    assert 200 < np.count_nonzero((first != found).any(axis=-1)) < 60_000


@pytest.mark.parametrize("what", ["text", "pose", "joints", "status"])
def test_a_record_that_was_tampered_with_is_refused(record, library, renderer, what):
    step = record.steps[1]
    scene = step.after.scene
    first = scene.objects[0]
    pose = replace(first.pose, position=(first.pose.position[0] + 1e-9, *first.pose.position[1:]))
    shifted = replace(scene, objects=(replace(first, pose=pose), *scene.objects[1:]))
    false = {
        "text": replace(step, text=step.text + " "),
        "status": replace(step, status="failed"),
        "pose": replace(step, after=replace(step.after, scene=shifted)),
        "joints": replace(step, after=replace(step.after, joints=(0.1, *step.after.joints[1:]))),
    }[what]
    forged = replace(record, steps=(record.steps[0], false, *record.steps[2:]))
    with pytest.raises(CantFilm, match=r"differs in step 2: (text|status|after)"):
        take(TASK, forged, library, renderer)


def test_what_can_t_be_done_again_is_refused(record, library, renderer):
    with pytest.raises(OtherTools, match="version 1 of the tools"):
        take(TASK, replace(record, tools=1), library, renderer)
    with pytest.raises(CantFilm, match="on a robot"):
        take(TASK, replace(record, frames=("frames/a/000",)), library, renderer)
