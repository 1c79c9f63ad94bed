"""A recording for Rerun's viewer holds what happened: read back, and held against the table."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from probe.episodes.play import play, score
from probe.episodes.turns import Call
from probe.film.footage import Footage, take
from probe.film.recording.recording import recording_of
from probe.manipulation.candidates import propose
from probe.manipulation.grasp import GraspResult
from probe.manipulation.handshape import HandShape
from probe.manipulation.obstacles import Obstacles
from probe.manipulation.routes import way_in, way_out
from probe.manipulation.target import target_of
from probe.manipulation.terrain import survey
from probe.render.photograph import load_scene
from probe.station.simulated import SimulatedStation
from probe.station.ur5 import Ur5
from probe.tasks.suite_file import demo_suite
from probe.types import Array, Pose
from probe.world.world import World
from recordings import Row, picture_of, poses_of, rows_of

pytestmark = pytest.mark.slow

TASK = demo_suite().tasks[0]
WORDS = "The pot may hide it."
CALLS = (
    Call.of("find_object", {"description": "clay flower pot"}, words=WORDS),
    Call.of("grasp_and_remove", {"object_id": "object_1"}),
    Call.of("push", {"object_id": "object_99", "direction": "left", "distance_cm": 5}),
    Call.of("answer_question", {"choice": "E"}),
)
GRASP = 2
"""Number of the grasp among the calls, from 1."""


class Fixed:
    """Makes the calls above."""

    def act(self, question, history):
        return CALLS[len(history)] if len(history) < len(CALLS) else None


@pytest.fixture(scope="module")
def footage(library, renderer) -> Footage:
    pytest.importorskip("rerun")
    record = play(TASK, Fixed(), "fixed", library, renderer)
    return take(TASK, record, library, renderer, looking=True)


@pytest.fixture(scope="module")
def rows(footage, library, renderer, tmp_path_factory) -> dict[str, list[Row]]:
    load_scene(renderer, TASK.scene, library)
    path: Path = tmp_path_factory.mktemp("recording") / "one.rrd"
    graded = score(TASK, footage.record, renderer)
    path.write_bytes(recording_of(footage, graded, library))
    return rows_of(path)


@pytest.fixture(scope="module")
def pot(footage) -> int:
    """The instance that was grasped: it alone ends up in the basket."""
    basket = TASK.setup.basket
    (inside,) = [o for o in footage.moments[-1].objects if basket.holds(*o.pose.position[:2])]
    return inside.instance


def entity_of(rows, instance: int) -> list[Row]:
    (name,) = [name for name in rows if name.startswith(f"/world/objects/{instance}_")]
    return rows[name]


def strips(row: Row) -> Array:
    """The polylines of a row, shape (n, k, 3)."""
    return np.array(row.values["LineStrips3D:strips"])


def test_the_hand_is_where_the_analytic_kinematics_have_it(footage, rows) -> None:
    arm = Ur5(TASK.setup.mount)
    seconds, places, turns = poses_of(rows["/world/robot/palm"], "time")
    at = {round(moment.time, 6): moment for moment in footage.moments}
    assert len(seconds) > 300
    for time, place, turn in list(zip(seconds, places, turns, strict=True))[::25]:
        hand = arm.forward(at[round(time, 6)].joints)
        assert place == pytest.approx(hand.position, abs=1e-5)
        assert Pose.of(place, np.roll(turn, 1)).rotation == pytest.approx(hand.rotation, abs=1e-5)


def test_the_other_timeline_has_the_table_as_it_stood_at_each_call(footage, rows) -> None:
    for instance, placed in enumerate(footage.moments[0].objects, start=1):
        steps, places, _ = poses_of(entity_of(rows, placed.instance), "step")
        assert steps.tolist() == [1, 2, 3, 4, 5], instance
        for place, scene in zip(places[1:], footage.record.scenes[1:], strict=True):
            assert place == pytest.approx(scene[placed.instance].pose.position, abs=2e-4)


def test_the_pot_is_carried_into_the_basket_and_nothing_else_is(footage, rows, pot) -> None:
    _, places, _ = poses_of(entity_of(rows, pot), "time")
    assert len(places) > 100 and TASK.setup.basket.holds(*places[-1][:2])
    assert places[:, 2].max() > TASK.setup.basket.size[2]
    objects = [name for name in rows if name.startswith("/world/objects/")]
    assert len(objects) == len(TASK.scene.objects)


@pytest.fixture(scope="module")
def planned(library, renderer, pot):
    """The grasps that fit on a fresh table, as planner and routes say when asked here."""
    load_scene(renderer, TASK.scene, library)
    station = SimulatedStation(World(TASK.scene, library), renderer)
    frame = station.observe(rgb=False)
    assert frame.labels is not None
    terrain = survey(frame, TASK.setup, station.look_into_basket(rgb=False))
    target = target_of(frame, frame.labels == pot, terrain)
    return station, terrain, target, propose(target, terrain, station.hand)


def test_as_many_hands_are_shown_by_verdict_as_there_were(rows, planned) -> None:
    station, terrain, target, grasps = planned
    shape = HandShape(station.hand)
    full = Obstacles.of(station.arm, terrain)
    bare = Obstacles.of(station.arm, terrain.without(target.cells))
    counts = dict.fromkeys(("chosen", "untried", "no_way_out", "no_way_in"), 0)
    for grasp in grasps:
        enter = way_in(station.arm, station.joints(), full, grasp, shape)
        points = shape.whole(grasp.opening)
        if counts["chosen"]:
            counts["untried"] += 1
        elif enter is None:
            counts["no_way_in"] += 1
        else:
            last, basket = enter.approach[-1], TASK.setup.basket
            left = way_out(bare, last, grasp, target, basket, points)
            counts["no_way_out" if left is None else "chosen"] += 1
    found = {name: told(rows, f"/world/plan/{name}") for name in (*counts, "out_of_reach")}
    found["no_way_in"] += found.pop("out_of_reach")
    assert found == counts and counts["chosen"] == 1
    (page,) = [row for row in rows["/grasps"] if "TextDocument:text" in row.values]
    assert f"| green | {counts['chosen']} | chosen |" in page.values["TextDocument:text"][0]


def told(rows, entity: str) -> int:
    """How many hands are shown; all of them at the grasp."""
    some = [row for row in rows.get(entity, []) if "LineStrips3D:strips" in row.values]
    assert all(row.step == GRASP for row in some)
    return sum(len(row.values["LineStrips3D:strips"]) for row in some)


def test_the_hand_went_where_the_chosen_one_is_drawn(footage, rows) -> None:
    """Held against the physics: where it was when the pads began to close on the pot."""
    (row,) = rows["/world/plan/chosen"]
    (outline,) = strips(row)
    openings = np.array([moment.opening for moment in footage.moments])
    closing = int(np.flatnonzero(np.diff(openings) < -1e-3)[0])
    seconds, places, turns = poses_of(rows["/world/robot/palm"], "time")
    now = int(np.searchsorted(seconds, footage.moments[closing].time, side="right")) - 1
    palm = Pose.of(places[now], np.roll(turns[now], 1))
    local = palm.inverse().apply(outline)
    # In the hand's frame: pads apart along y, the same on both sides, fingers along z.
    assert np.abs(local[:, 0]).max() < 0.004
    assert local[0, 1] == pytest.approx(-local[-1, 1], abs=0.006)
    assert np.ptp(local[:, 1]) == pytest.approx(openings[closing], abs=0.006)
    assert row.time == pytest.approx(footage.moments[footage.calls[GRASP - 1].first].time, abs=0.02)
    (path,) = [row for row in rows["/world/hand_path"] if "LineStrips3D:strips" in row.values]
    middle = outline[[0, -1]].mean(axis=0)
    assert np.linalg.norm(strips(path)[0] - middle, axis=1).min() < 0.04


def test_points_have_the_colours_that_the_camera_has_there(footage, rows) -> None:
    first, *later = rows["/world/seen/table"]
    points, packed = first.array("Points3D:positions")[:], first.array("Points3D:colors")
    pixels = TASK.setup.camera().project(points.reshape(-1, 3)[::997])
    columns, lines = np.floor(pixels).astype(int).T
    rgb = np.stack([packed[::997] >> shift & 255 for shift in (24, 16, 8)], axis=-1)
    assert (footage.question.picture[lines, columns] == rgb).mean() > 0.99
    assert len(later) == 1 and later[0].step == GRASP + 1


def test_the_pots_region_is_the_pot(footage, rows, renderer, library, pot) -> None:
    load_scene(renderer, TASK.scene, library)
    labels = renderer.labels(TASK.scene.objects, TASK.setup.camera())
    images = [row for row in rows["/tools/things"] if "SegmentationImage:buffer" in row.values]
    names = [row for row in rows["/tools/things"] if "AnnotationContext:context" in row.values]
    numbers = np.frombuffer(bytes(images[0].values["SegmentationImage:buffer"][0]), np.uint16)
    classes = {
        each["class_id"]: each["class_description"]["info"]["label"]
        for each in names[0].values["AnnotationContext:context"][0]
    }
    (number,) = [key for key, name in classes.items() if name and "clay flower pot" in name]
    assert ((numbers.reshape(labels.shape) == number) == (labels == pot)).all()


def test_pictures_are_the_agents(footage, rows) -> None:
    """Told once: neither the push that did nothing nor the answer showed another one."""
    assert [row.step for row in rows["/agent/picture"]] == [1, 2, 3]
    seen = [picture_of(row) for row in rows["/agent/picture"]]
    for picture, real in zip([*seen, seen[-1], seen[-1]], footage.pictures, strict=True):
        assert (picture == real).all()


def test_the_log_tells_all_in_order(footage, rows) -> None:
    steps = footage.record.steps
    said = [(row.values["TextLog:text"][0], row.step) for row in rows["/log"]]
    told = [f"Told: {step.text}" for step in steps]
    assert said[0][0].startswith(footage.question.text) and said[1] == (f"Agent: {WORDS}", 1)
    assert said[2][0] == "Call 1 of 4: find_object(description=clay flower pot)"
    assert said[3:5] == [(told[0], 1), ("Call 2 of 4: grasp_and_remove(object_id=object_1)", 2)]
    assert said[5][0].startswith("Call 2 of 4, try 1: 1 chosen; ") and said[6] == (told[1], 2)
    assert [each for each in said[7:] if each[0].startswith("Told")] == [(told[2], 3), (told[3], 4)]
    assert said[-1] == ("The episode ended: answered. It counts as: right.", 5)
    levels = [row.values["TextLog:level"][0] for row in rows["/log"]]
    assert [n for n, level in enumerate(levels) if level != "INFO"] == [said.index((told[2], 3))]


def test_texts_stand_when_they_were_told(footage, rows) -> None:
    times = [row.time for row in rows["/log"] if row.values["TextLog:text"][0].startswith("Told")]
    lasts = [footage.moments[call.last].time for call in footage.calls]
    assert times == pytest.approx(lasts, abs=0.02)  # Moments are 18 ms apart.


def test_what_the_skill_says_is_what_is_shown(footage, rows) -> None:
    outcome = footage.calls[GRASP - 1].outcome
    assert isinstance(outcome, GraspResult) and outcome.status == "removed"
    fits = ("chosen", "untried", "spent", "no_way_out", "no_way_in", "out_of_reach")
    assert sum(told(rows, f"/world/plan/{name}") for name in fits) == outcome.candidates
