"""One class of skills: with noise, and with grasps that always work."""

from __future__ import annotations

import numpy as np
import pytest

from boxes import box_library, standing, station_at
from probe.episodes.arm_skills import ArmSkills
from probe.episodes.noise import HandErrors, Noise
from probe.render.renderer import Renderer
from probe.scene.setup import UR5_TABLE

LIBRARY = box_library(red_block=(0.05, 0.05, 0.05, 190, 40, 40))
SCENE = standing(LIBRARY, ("red_block", 0.0, 0.05, 0.0))


@pytest.fixture(scope="module")
def renderer():
    with Renderer() as drawing:
        yield drawing


def grasp(renderer: Renderer, skills: ArmSkills):
    """What came of a grasp, and where the hand came closest to the table."""
    station = station_at(SCENE, LIBRARY, renderer)
    frame = station.observe(rgb=False)
    places: list[tuple[float, ...]] = []
    follow = station.follow

    def watched(path):
        places.extend(station.arm.forward(joints).position for joints in path)
        return follow(path)

    station.follow = watched
    result = skills.grasp_and_remove(station, frame, frame.labels == 1, UR5_TABLE)
    return result, np.array(min(places, key=lambda place: place[2]))


def test_the_hand_goes_beside_where_it_was_sent_by_the_drawn_error(renderer: Renderer):
    noise = Noise(grasp=0.004)
    _, lowest = grasp(renderer, ArmSkills())
    _, erring = grasp(renderer, ArmSkills(noise, seed=3, run=1))
    first = station_at(SCENE, LIBRARY, renderer).observe(rgb=False)
    error = HandErrors(noise, 3, 1).draw("grasp", first, first.labels == 1)
    assert error is not None
    assert erring[:2] - lowest[:2] == pytest.approx(error[:2], abs=0.001)


def test_what_most_of_the_mask_shows_is_taken_away_at_once(renderer: Renderer):
    table = station_at(SCENE, LIBRARY, renderer)
    frame = table.observe(rgb=False)
    assert frame.labels is not None
    mask = frame.labels == 1
    mask[0, 0] = True
    skills = ArmSkills(removal=table)
    result = skills.grasp_and_remove(table, frame, mask, UR5_TABLE)
    assert result.status == "removed" and result.tries == 0
    pose = table.snapshot()[1].pose
    assert UR5_TABLE.basket.holds(*pose.position[:2])
    assert result.frame.labels is not None and not (result.frame.labels == 1).any()


def test_the_bare_table_gives_nothing_to_take_away(renderer: Renderer):
    table = station_at(SCENE, LIBRARY, renderer)
    frame = table.observe(rgb=False)
    assert frame.labels is not None
    result = ArmSkills(removal=table).grasp_and_remove(table, frame, frame.labels == 0, UR5_TABLE)
    assert (result.status, result.frame) == ("no_candidate", frame)
