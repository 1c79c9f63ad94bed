"""Both skills with real physics."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
import trimesh

from bodies import at, box_item, spec_of
from manipulation.standing import grasp_first, is_in_basket, is_parked, position, stand
from probe.assets.mesh.mesh import Body, ConvexPiece
from probe.manipulation.candidates import Grasp, propose
from probe.manipulation.grasp import grasp_and_remove
from probe.manipulation.kinematics import moved
from probe.manipulation.push import LONGEST, push
from probe.manipulation.target import Target
from probe.manipulation.terrain import Terrain
from probe.manipulation.verdicts import judged
from probe.render.renderer import Renderer
from probe.scene.setup import UR5_TABLE
from probe.station.simulated import SimulatedStation
from probe.station.station import Hand
from probe.station.ur5 import Ur5
from probe.types import Array, Pose
from probe.world.model import Item
from probe.world.world import World
from shapes import plain, textured

RED = box_item(1, "red box", (0.09, 0.05, 0.06), mass=0.2)


@pytest.fixture(scope="module")
def renderer() -> Iterator[Renderer]:
    with Renderer() as drawing:
        yield drawing


def mug(instance: int) -> Item:
    """An open cylinder of 16 staves with a floor and a handle, 8 cm wide and 9 cm high."""
    parts = [trimesh.creation.cylinder(0.037, 0.005, sections=16)]
    parts[0].apply_translation((0, 0, 0.0025))
    for angle in np.arange(16) * np.pi / 8:
        stave = trimesh.creation.box((0.004, 0.0165, 0.085))
        stave.apply_translation((0.038, 0, 0.0475))
        stave.apply_transform(trimesh.transformations.rotation_matrix(float(angle), (0, 0, 1)))
        parts.append(stave)
    for size, place in (
        ((0.025, 0.012, 0.010), (0.052, 0, 0.075)),
        ((0.025, 0.012, 0.010), (0.052, 0, 0.025)),
        ((0.010, 0.012, 0.060), (0.066, 0, 0.050)),
    ):
        part = trimesh.creation.box(size)
        part.apply_translation(place)
        parts.append(part)
    pieces = tuple(ConvexPiece(np.asarray(part.vertices, float)) for part in parts)
    whole = trimesh.util.concatenate(parts)
    assert isinstance(whole, trimesh.Trimesh)
    mesh = textured(whole, plain(60, 90, 180))
    return Item(instance, spec_of("blue mug", (0.12, 0.08, 0.09), 0.25), Body(mesh, pieces))


@pytest.mark.slow
def test_a_box_among_others_ends_in_the_basket_and_the_arm_is_parked(renderer: Renderer) -> None:
    green = box_item(2, "green box", (0.06, 0.06, 0.10))
    station = stand(renderer, [RED, green], [at(0.05, 0.08), at(0.05, 0.17)])
    result = grasp_first(station)
    assert result.status == "removed" and result.tries == 1
    assert is_in_basket(position(station)) and is_parked(station)
    assert position(station, 2) == pytest.approx([0.05, 0.17, 0.0], abs=0.005)
    assert result.frame.labels is not None and not (result.frame.labels == 1).any()
    sides = (0.05, 0.09)
    assert min(abs(result.width - side) for side in sides) < 0.005


@pytest.mark.slow
def test_a_mug_ends_in_the_basket(renderer: Renderer) -> None:
    station = stand(renderer, [mug(1)], [at(-0.1, 0.1)])
    assert grasp_first(station).status == "removed"
    assert is_in_basket(position(station)) and is_parked(station)


def test_what_is_too_wide_is_left_alone(renderer: Renderer) -> None:
    slab = box_item(1, "red slab", (0.2, 0.2, 0.02))
    station = stand(renderer, [slab], [at(0.0, 0.0)])
    result = grasp_first(station)
    assert (result.status, result.tries, result.candidates) == ("no_candidate", 0, 0)
    assert position(station) == pytest.approx([0.0, 0.0, 0.0], abs=1e-6)


@pytest.mark.slow
def test_a_book_over_a_smaller_box_is_taken_by_its_edge(renderer: Renderer) -> None:
    book = box_item(1, "red book", (0.14, 0.19, 0.02), mass=0.3)
    box = box_item(2, "green box", (0.05, 0.06, 0.05))
    station = stand(renderer, [book, box], [at(0.0, 0.05, 0.05), at(0.0, 0.05)])
    assert grasp_first(station).status == "removed"
    assert is_in_basket(position(station)) and is_parked(station)
    assert position(station, 2) == pytest.approx([0.0, 0.05, 0.0], abs=0.03)


@pytest.mark.slow
def test_after_a_vain_pinch_the_arm_withdraws_and_is_parked(renderer: Renderer) -> None:
    anvil = box_item(1, "red anvil", (0.14, 0.19, 0.02), mass=60.0)
    block = box_item(2, "green block", (0.05, 0.06, 0.05), mass=20.0)
    station = stand(renderer, [anvil, block], [at(0.0, 0.05, 0.05), at(0.0, 0.05)])
    result = grasp_first(station)
    assert result.status in ("blocked", "slipped", "moved") and result.tries == 1
    assert is_parked(station)


@pytest.mark.slow
def test_after_a_vain_grasp_by_an_edge_it_is_gripped_across(renderer: Renderer) -> None:
    asked = list[int]()

    def in_the_air(target: Target, terrain: Terrain, hand: Hand) -> list[Grasp]:
        best = propose(target, terrain, hand)[0]
        asked.append(1)
        return [replace(best, hand=moved(best.hand, (0.0, 0.0, 0.1)), by_edge=True)]

    station = stand(renderer, [RED], [at(0.0, 0.0)])
    frame = station.observe(rgb=False)
    assert frame.labels is not None
    planners = (in_the_air, propose)
    result = grasp_and_remove(station, frame, frame.labels == 1, UR5_TABLE, planners)
    assert (result.status, result.tries, len(asked)) == ("removed", 2, 2)
    assert is_in_basket(position(station)) and is_parked(station)


class Lame(Ur5):
    """An arm that reaches nothing."""

    def inverse(self, world_from_tool: Pose) -> list[Array]:
        return []


def test_an_arm_that_reaches_nothing_says_so(renderer: Renderer) -> None:
    station = stand(renderer, [RED], [at(0.0, 0.0)])
    station.arm = Lame()
    assert grasp_first(station).status == "unreachable"
    frame = station.observe(rgb=False)
    assert frame.labels is not None
    assert push(station, frame, frame.labels == 1, "up", 0.1, UR5_TABLE).status == "unreachable"
    assert is_parked(station)


class Stuck(SimulatedStation):
    """A station whose arm is held back on its third motion."""

    moves = 0

    def follow(self, path: Array) -> bool:
        self.moves += 1
        return self.moves % 5 != 2 and super().follow(path)


def test_an_arm_that_is_stopped_goes_home_and_says_so(renderer: Renderer) -> None:
    plain_station = stand(renderer, [RED], [at(0.0, 0.0)])
    station = Stuck(plain_station._world, renderer)
    result = grasp_first(station)
    assert result.status == "blocked" and result.tries > 1
    assert is_parked(station)
    assert position(station) == pytest.approx([0.0, 0.0, 0.0], abs=0.005)


def test_what_stops_the_arm_is_met_three_times_at_most(renderer: Renderer) -> None:
    class Held(SimulatedStation):
        """An arm that no way into a grasp can be followed with."""

        def follow(self, path: Array) -> bool:
            return not np.allclose(path[0], self.arm.parked) and super().follow(path)

    station = Held(stand(renderer, [RED], [at(0.0, 0.0)])._world, renderer)
    result = grasp_first(station)
    assert (result.status, result.tries) == ("blocked", 3)


class Slippery(SimulatedStation):
    """A hand that feels nothing between its pads from one of its closings on.

    Before the last of three closings it is over the basket.
    """

    first, closings = 1, 0

    def grip(self, opening: float) -> float:
        if opening > 0:
            return super().grip(opening)
        self.closings += 1
        return super().grip(opening) if self.closings < self.first else 0.0


def test_what_slips_is_tried_five_times(renderer: Renderer) -> None:
    station = Slippery(stand(renderer, [RED], [at(0.0, 0.0)])._world, renderer)
    result = grasp_first(station)
    assert (result.status, result.tries) == ("slipped", 5)
    assert is_parked(station)
    assert position(station) == pytest.approx([0.0, 0.0, 0.0], abs=0.005)


def test_what_was_lost_on_the_way_to_the_basket_is_left_alone(renderer: Renderer) -> None:
    station = Slippery(stand(renderer, [RED], [at(0.0, 0.0)])._world, renderer)
    station.first = 3
    result = grasp_first(station)
    assert (result.status, result.tries) == ("dropped", 1)
    assert is_parked(station)


class Noted(Stuck):
    """The same, with what it was told to follow."""

    def __init__(self, world: World, renderer: Renderer) -> None:
        super().__init__(world, renderer)
        self.paths: list[Array] = []

    def follow(self, path: Array) -> bool:
        self.paths.append(path)
        return super().follow(path)


def test_each_try_is_what_its_plan_says(renderer: Renderer) -> None:
    """And none resembles one that failed before it, which the verdicts tell, too."""
    station = Noted(stand(renderer, [RED], [at(0.0, 0.0)])._world, renderer)
    result = grasp_first(station)
    removals = [plan.removal for plan in result.plans if plan.removal is not None]
    assert len(removals) == result.tries > 1
    planned = [removal.enter.transit for removal in removals]
    begun = [path for path in station.paths if any(path is one for one in planned)]
    assert all(path is one for path, one in zip(begun, planned, strict=True))
    times = [plan.frame.taken or 0.0 for plan in result.plans]
    assert times[0] == 0.0 and all(before < after for before, after in pairwise(times))
    for number, plan in enumerate(result.plans[: result.tries]):
        found = judged(plan, station.arm, station.hand)
        (chosen,) = [each.grasp for each in found if each.verdict == "chosen"]
        assert chosen == removals[number].grasp
        assert (number > 0) == any(each.verdict == "spent" for each in found)
        for failed in removals[:number]:
            apart = np.linalg.norm(np.subtract(chosen.middle, failed.grasp.middle))
            cosine = abs(chosen.hand.rotation[:, 1] @ failed.grasp.hand.rotation[:, 1])
            assert apart > 0.012 or cosine < np.cos(np.radians(25))


@pytest.mark.slow
@pytest.mark.parametrize(
    ("direction", "along"),
    [("right", (1, 0)), ("left", (-1, 0)), ("up", (0, 1)), ("down", (0, -1))],
)
@pytest.mark.parametrize("distance", [0.04, 0.12])
def test_a_box_goes_as_far_as_it_is_pushed(renderer, direction, along, distance) -> None:
    station = stand(renderer, [RED], [at(0.02, 0.05)])
    frame = station.observe(rgb=False)
    assert frame.labels is not None
    result = push(station, frame, frame.labels == 1, direction, distance, UR5_TABLE)
    assert result.status == "pushed" and is_parked(station)
    way = position(station)[:2] - [0.02, 0.05]
    assert way @ np.array(along) == pytest.approx(distance, abs=0.01)
    # One narrow contact turns a box a little, and so it strays.
    assert np.linalg.norm(way - (way @ np.array(along)) * np.array(along)) < 0.02
    assert result.swept == pytest.approx(distance, abs=0.008)
    assert result.moved == pytest.approx(way @ np.array(along), abs=0.006)


@pytest.mark.slow
def test_without_room_behind_it_is_taken_along_from_above(renderer: Renderer) -> None:
    wall = box_item(2, "green wall", (0.34, 0.30, 0.15), mass=1.0)
    station = stand(renderer, [RED, wall], [at(0.02, 0.05), at(-0.196, 0.05)])
    frame = station.observe(rgb=False)
    assert frame.labels is not None
    result = push(station, frame, frame.labels == 1, "right", 0.1, UR5_TABLE)
    assert result.status == "pushed" and is_parked(station)
    # It may slip or tip beneath the tips, but comes at least half of the way.
    assert position(station)[0] - 0.02 > 0.05
    assert position(station, 2) == pytest.approx([-0.196, 0.05, 0.0], abs=0.005)


def test_without_room_behind_or_above_nothing_is_pushed(renderer: Renderer) -> None:
    behind = box_item(2, "wall behind", (0.34, 0.06, 0.25), mass=1.0)
    beside = [box_item(n, f"wall {n}", (0.45, 0.14, 0.25), mass=1.0) for n in (3, 4)]
    places = [at(0.02, 0.05), at(-0.196, 0.05), at(-0.1, 0.15), at(-0.1, -0.05)]
    station = stand(renderer, [RED, behind, *beside], places)
    frame = station.observe(rgb=False)
    assert frame.labels is not None
    assert push(station, frame, frame.labels == 1, "right", 0.1, UR5_TABLE).status == "no_space"
    assert position(station) == pytest.approx([0.02, 0.05, 0.0], abs=1e-6)


@pytest.mark.slow
def test_what_leaves_the_picture_in_part_is_pushed_on(renderer: Renderer) -> None:
    station = stand(renderer, [RED], [at(0.20, 0.05)])
    frame = station.observe(rgb=False)
    assert frame.labels is not None
    result = push(station, frame, frame.labels == 1, "right", 0.06, UR5_TABLE)
    assert result.status == "pushed" and result.moved == pytest.approx(0.06, abs=0.01)
    assert position(station)[0] == pytest.approx(0.26, abs=0.01)


def test_a_push_into_the_basket_stops_before_its_wall(renderer: Renderer) -> None:
    station = stand(renderer, [RED], [at(-0.18, -0.262)])
    frame = station.observe(rgb=False)
    assert frame.labels is not None
    result = push(station, frame, frame.labels == 1, "left", LONGEST, UR5_TABLE)
    assert result.status == "short" and result.swept < LONGEST
    wall = UR5_TABLE.basket.position[0] + UR5_TABLE.basket.size[0] / 2
    assert wall < position(station)[0] - 0.045 < wall + 0.06


def test_a_push_has_limits(renderer: Renderer) -> None:
    station = stand(renderer, [RED], [at(0.0, 0.0)])
    frame = station.observe(rgb=False)
    with pytest.raises(ValueError, match=r"0\.03 to 0\.2"):
        push(station, frame, np.ones(frame.depth.shape, bool), "up", 0.5, UR5_TABLE)
