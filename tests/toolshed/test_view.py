"""What a detector is given to look at."""

from __future__ import annotations

import numpy as np
import pytest

from probe.perception.things import Thing
from probe.scene.setup import UR5_TABLE, Basket
from probe.toolshed.view import CurrentView
from probe.types import Frame


class Onlooker:
    """Detects nothing, and keeps the frames that it is given."""

    def __init__(self) -> None:
        self.frames: list[Frame] = []

    def needs_rgb(self, frame: Frame) -> bool:
        return False

    def detect(self, frame: Frame) -> tuple[Thing, ...]:
        self.frames.append(frame)
        return ()


def floor_as_seen(station, position) -> np.ndarray:
    """Where a detector takes the middle of a basket's floor to be, metres."""
    onlooker = Onlooker()
    _ = CurrentView(station, onlooker, Basket(position)).look
    camera, taken = onlooker.frames[0].camera, station.look_into_basket(rgb=True).camera
    ((u, v),) = taken.project(np.array([position]))
    depth = taken.world_from_camera.inverse().apply(np.array([position]))[:, 2]
    return camera.lift(np.array([[u, v]]), depth)[0]


@pytest.mark.parametrize(
    ("position", "seen"),
    [
        (UR5_TABLE.basket.position, UR5_TABLE.basket.position),
        ((-0.55, -0.44, -0.15), (-0.55, -0.44, 0.0)),
        ((-0.55, -0.44, 0.1), (-0.55, -0.44, 0.0)),
        ((-0.9, -0.44, -0.3), (0.0, 0.0, 0.0)),
    ],
)
def test_a_baskets_floor_is_where_detectors_look_for_things_to_stand(station, position, seen):
    assert floor_as_seen(station, position) == pytest.approx(np.array(seen), abs=1e-9)
