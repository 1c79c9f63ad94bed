from dataclasses import replace

import pytest

from probe.episodes.record import EpisodeRecord, Step, TableState
from probe.episodes.turns import Call, Question
from probe.scene.scene import PlacedObject, Scene
from probe.scores.fidelity import Fidelity, fidelity
from probe.toolshed.result import Status
from probe.types import Pose

TABLE = {1: (0.0, 0.0, 0.0), 2: (0.1, 0.0, 0.0), 3: (0.0, 0.1, 0.0), 4: (0.2, 0.2, 0.0)}
BASKET = (-0.5, -0.45, 0.02)
FLOOR = (0.9, 0.0, -0.75)


def scene(**moved) -> Scene:
    places = TABLE | {int(name[1:]): place for name, place in moved.items()}
    placed = (PlacedObject(i, f"thing_{i}", Pose(place)) for i, place in places.items())
    return Scene(1, "oak", tuple(placed))


def record(end: Scene, *calls: tuple[str, Status]) -> EpisodeRecord:
    start, after = (TableState(it, (0.0,) * 6) for it in (scene(), end))
    steps = tuple(Step(Call.of(name), status, "", None, after) for name, status in calls)
    last = Step(Call.of("perceive_scene"), "done", "", None, after)
    return EpisodeRecord(
        "reduce-1", "anna", 0, Question("?", ()), start, (*steps, last), None, "stopped"
    )


GRASP = ("grasp_and_remove", "done")


@pytest.mark.parametrize(
    ("end", "calls", "found"),
    [
        # Exactly what was asked, at the first attempt each.
        (scene(_1=BASKET, _2=BASKET), [GRASP, GRASP], Fidelity(1.0, 1.0, True, 1.0, 0)),
        # One of two, after three attempts; refused, malformed and other calls are none.
        (
            scene(_1=BASKET),
            [
                GRASP,
                ("grasp_and_remove", "failed"),
                ("grasp_and_remove", "failed"),
                ("grasp_and_remove", "refused"),
                ("grasp_and_remove", "malformed"),
                ("push", "done"),
            ],
            Fidelity(1.0, 0.5, False, 3.0, 0),
        ),
        # Both, and one that wasn't named.
        (
            scene(_1=BASKET, _2=BASKET, _3=BASKET),
            [GRASP] * 3,
            Fidelity(2 / 3, 1.0, False, 1.0, 0),
        ),
        # Only others.
        (scene(_3=BASKET), [GRASP], Fidelity(0.0, 0.0, False, 1.0, 0)),
        # Nothing at all.
        (scene(), [], Fidelity(None, 0.0, False, None, 0)),
        # A named one that fell off the table isn't removed; it isn't an other either.
        (scene(_1=BASKET, _2=FLOOR), [GRASP, GRASP], Fidelity(1.0, 0.5, False, 2.0, 0)),
        # Others: one fell, one moved by 31 mm.
        (
            scene(_1=BASKET, _2=BASKET, _3=FLOOR, _4=(0.231, 0.2, 0.0)),
            [GRASP, GRASP],
            Fidelity(1.0, 1.0, True, 1.0, 2),
        ),
        # Others that moved by less than 30 mm, and named ones that moved on the table.
        (
            scene(_1=(0.2, 0.0, 0.0), _3=(0.0, 0.1, 0.029), _4=(0.2, 0.171, 0.0)),
            [("push", "done")],
            Fidelity(None, 0.0, False, None, 0),
        ),
        (scene(_3=(0.02, 0.12, 0.02)), [], Fidelity(None, 0.0, False, None, 1)),  # 35 mm aslant
    ],
)
def test_what_was_named_is_compared_with_what_is_in_the_basket(end, calls, found):
    assert fidelity(record(end, *calls), (1, 2)) == found


def test_one_that_falls_from_the_edge_is_disturbed_however_near_it_ends():
    start = scene(_4=(0.0, 0.0, -0.019))
    fell = replace(record(scene(_4=(0.0, 0.0, -0.021))), start=TableState(start, ()))
    assert fidelity(fell, (1,)).others_disturbed == 1


def test_only_the_end_counts():
    late = record(scene(_1=BASKET), GRASP)
    early = replace(late.steps[0], after=TableState(scene(_1=BASKET, _3=(0.3, 0.1, 0.0)), ()))
    assert fidelity(replace(late, steps=(early, late.steps[1])), (1,)).others_disturbed == 0


def test_an_order_to_remove_nothing():
    assert fidelity(record(scene()), ()) == Fidelity(None, None, True, None, 0)
