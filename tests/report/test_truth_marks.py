from dataclasses import replace

import numpy as np
import pytest

from played_examples import played
from probe.report.episodes import index_of
from probe.report.truth_marks import truth_places
from probe.tasks.task import Mark
from probe.types import Pose
from run_folders import DEMO, episode, on_robot

TASK = next(task for task in DEMO.tasks if task.question_type == "beneath")


def standing(record, instance, place):
    """The record with a thing in another place, from its second step on."""

    def moved(scene):
        objects = tuple(
            replace(it, pose=Pose(place, it.pose.wxyz)) if it.instance == instance else it
            for it in scene.objects
        )
        return replace(scene, objects=objects)

    steps = tuple(
        replace(it, after=replace(it.after, scene=moved(it.after.scene))) if number else it
        for number, it in enumerate(record.steps)
    )
    return replace(record, steps=steps)


def test_the_true_thing_is_marked_where_it_stands_and_no_longer_once_it_is_gone():
    (target,) = TASK.targets
    camera = TASK.viewpoint.camera
    record = standing(episode(TASK), target, (0.1, 0.2, 0.0))
    start, first, second, *_ = truth_places(TASK, record)
    (thing,) = [it for it in TASK.scene.objects if it.instance == target]
    wanted = camera.project(np.array([thing.pose.position]))[0] / camera.width_px
    assert start == first == [pytest.approx(wanted, abs=0.001)]
    # 10 cm to the right of the middle and 20 cm up, where a picture shows so many metres.
    metres = (
        TASK.setup.camera(TASK.camera).width_px
        / camera.focal_px
        * camera.world_from_camera.position[2]
    )
    assert second == [pytest.approx((0.5 + 0.1 / metres, 0.5 - 0.2 / metres), abs=0.001)]
    gone = standing(episode(TASK), target, (5.0, 5.0, 0.0))
    assert truth_places(TASK, gone)[1:] == [start, [], [], []]


def test_of_two_marked_things_the_right_one_is_true():
    one, other = (it.instance for it in TASK.scene.objects[:2])
    marks = (Mark("A", one, (1, 2)), Mark("B", other, (3, 4)))
    task = replace(TASK, marks=marks, targets=(one, other), answer="B")
    alone = replace(TASK, targets=(other,))
    assert truth_places(task, episode(TASK)) == truth_places(alone, episode(TASK))
    assert len(truth_places(task, episode(TASK))[0]) == 1


def test_on_a_robot_nothing_is_marked(tmp_path):
    assert truth_places(TASK, on_robot(episode(TASK), tmp_path)) == [[]] * 5


def test_only_wrong_answers_are_shown_the_truth():
    right, wrong = played(episode(TASK)), played(episode(TASK, run=1, right=False))
    index = index_of([right, wrong], [right.row.entrant], {})
    assert [bool(it["true_places"]) for it in index["episodes"]] == [False, True]
