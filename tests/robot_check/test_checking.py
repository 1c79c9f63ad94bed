"""All of a robot's checks on a twin, with its flaws on, and faults planted in its process."""

from __future__ import annotations

import json
from collections.abc import Iterator
from contextlib import closing
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from faults import plant
from probe_bridge.checks.outcome import Outcome

from probe.errors import OutputFailed
from probe.render.renderer import Renderer
from probe.robot_check import checking
from probe.robot_check.box import KnownBox
from probe.robot_check.calibration import calibrated
from probe.robot_check.carrying import Carrier
from probe.robot_check.checking import Wishes, check, kit_of
from probe.robot_check.corrected import corrected
from probe.robot_check.errors import Impossible
from probe.robot_check.holding import Cell, held_up, sightings
from probe.scene.setup_file import read_setup
from probe.station.remote import RobotStation, connected
from probe.twin.flaws import Flaws
from probe.twin.only_box import BoxLibrary, box_scene
from probe.twin.serving import TwinSettings, listening, twin_of
from probe.types import Pose

TOKEN = "a token for nobody else"
JACO = read_setup(Path(__file__).parents[2] / "examples" / "setups" / "jaco.json")
SETUP = replace(JACO, picture_px=256)
BOX = KnownBox()


@pytest.fixture
def twin(tmp_path: Path) -> Iterator[tuple]:
    settings = TwinSettings(Flaws(), haste=2.0, seed=5, views=("front",))
    with (
        Renderer() as renderer,
        twin_of(box_scene(SETUP, 5), BoxLibrary(BOX.size, tmp_path), renderer, settings) as robot,
        listening(robot, TOKEN, "127.0.0.1", 0) as address,
    ):
        yield robot, address


def off_at_the_table(pose: Pose, true: Pose) -> float:
    """By how much a camera with a wrong pose sees things of the work area elsewhere, metres."""
    edges = np.linspace(-0.15, 0.15, 3)
    points = np.stack(np.meshgrid(edges, edges, [0.0, 0.2]), axis=-1).reshape(-1, 3)
    seen = pose.apply(true.inverse().apply(points))
    return float(np.linalg.norm(seen - points, axis=1).max())


@pytest.mark.slow
def test_a_flawed_cameras_pose_is_recovered_by_a_box(twin) -> None:
    robot, address = twin
    client = connected(address, TOKEN)
    station = RobotStation(client, SETUP, "front")
    shown = held_up(Cell(client, station, SETUP, ("front",), BOX), 8)
    camera = client.description.cameras["front"]
    told = Pose(camera.position, camera.wxyz)
    client.close()
    found = calibrated(sightings(shown["front"]), BOX, SETUP.mount.base)
    true = robot._driver._cameras["front"].world_from_camera
    assert found.fault == "" and found.places >= 8
    assert off_at_the_table(found.corrected, true) < 0.0015 < 0.004 < off_at_the_table(told, true)
    assert found.after is not None and found.after < found.before / 2
    cameras = {each.name: each for each in corrected(client.description.cameras, [found])}
    assert Pose(cameras["front"].position, cameras["front"].wxyz) == found.corrected
    assert cameras["basket"] == client.description.cameras["basket"]
    scene, _ = robot._driver._body.scene()
    assert SETUP.basket.holds(*scene.objects[0].pose.position[:2])


def outcomes_of(address: str, tmp_path: Path) -> list[Outcome]:
    kit = kit_of(address, TOKEN, None, lambda outcome: None)
    check(kit, Wishes(SETUP, BOX, corrected=tmp_path / "cameras.json"), lambda text: False)
    return kit.outcomes


@pytest.mark.parametrize("fault", ["", "depth in millimetres", "stale frames", "wrong version"])
def test_what_needs_no_motion_is_checked_where_nobody_wants_any(twin, tmp_path, fault) -> None:
    robot, address = twin
    if fault:
        plant(robot, fault, 3)
    outcomes = outcomes_of(address, tmp_path)
    assert {each.fault for each in outcomes if each.verdict == "failed"} == ({fault} - {""})
    skipped = {each.check for each in outcomes if each.verdict == "skipped"}
    assert {"box", "reach", "pick"} <= skipped
    assert not (tmp_path / "cameras.json").exists()
    assert json.dumps([each.values() for each in outcomes])


def test_a_box_is_not_let_go_where_no_way_leads_over_the_basket(twin) -> None:
    robot, address = twin
    far = replace(SETUP, basket=replace(SETUP.basket, position=(4.0, 4.0, 0.0)))
    with closing(connected(address, TOKEN)) as client:
        carrier = Carrier(RobotStation(client, SETUP, "front"), far, BOX)
        before = robot._driver.opening()
        with pytest.raises(Impossible, match=r"over the basket, so the hand still holds it\."):
            carrier.drop()
        assert robot._driver.opening() == pytest.approx(before, abs=1e-6)


@pytest.mark.parametrize("asked", [1, 2])
def test_what_was_found_before_an_error_is_kept_and_the_error_stands_at_its_check(
    twin, monkeypatch, asked
) -> None:
    _, address = twin
    monkeypatch.setattr(checking, "_look_at_box", lambda *_: fail("cameras.json"))
    monkeypatch.setattr(checking, "pick", lambda *_: fail("the pick"))
    answers = iter([asked == 1, True])
    kit = kit_of(address, TOKEN, None, lambda outcome: None)
    checking._with_box(kit, Wishes(SETUP, BOX, pick=True), lambda text: next(answers))
    failed = [each for each in kit.outcomes if each.fault == "ended early"]
    assert [each.check for each in failed] == [["box"], ["pick"]][asked - 1]
    assert "reach" in {each.check for each in kit.outcomes}


def test_a_set_up_that_is_another_robots_is_told_and_nothing_is_moved(twin) -> None:
    _, address = twin
    other = replace(SETUP, mount=replace(SETUP.mount, parked=SETUP.mount.parked[:-1]))
    kit = kit_of(address, TOKEN, None, lambda outcome: None)
    checking._with_box(kit, Wishes(other, BOX), lambda text: pytest.fail("asked to move"))
    verdicts = {each.check: each.verdict for each in kit.outcomes}
    assert verdicts == {"reach": "failed", "box": "skipped", "pick": "skipped"}
    assert kit.outcomes[0].fault == "wrong set-up"


def fail(what: str) -> None:
    raise OutputFailed(what, "no space left")
