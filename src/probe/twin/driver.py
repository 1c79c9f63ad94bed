"""The twin as a bridge's driver. To whoever is behind the bridge it is a robot like any other."""

from __future__ import annotations

import threading
import time
from collections.abc import Mapping
from typing import TYPE_CHECKING

import numpy as np

from probe.render.renderer import Renderer
from probe.scene.scene import PlacedObject
from probe.stage.stage import FilmStage
from probe.station.remote import PARKED
from probe.twin.body import TwinBody, TwinMoment
from probe.twin.flaws import Flaws, misplaced, noisy_colours, noisy_depth
from probe.types import Array, Camera, Frame

if TYPE_CHECKING:
    from probe_bridge.driver import Reading, Shot
    from probe_bridge.trajectory import Trajectory

_UNIT = 1e-4
"""Metres that one step of the depth stands for on the wire."""

_PERIOD = 1 / 30
"""Seconds between two pictures of a camera."""


class TwinDriver:
    """Moves a TwinBody and photographs it with flawed cameras. Labels never leave the renderer.

    Pictures in colour show the robot; those of depth alone, by which `probe robot check` finds the
    box in the hand, show the things alone.

    Args:
        body: The table; closed with the driver.
        renderer: Has the scene's objects and the robot loaded.
        stage: The robot as it is drawn.
        cameras: By the bridge's names, where their calibration says that they stand.
        flaws: Of every camera.
        seed: Of all that is drawn by chance.
    """

    def __init__(
        self,
        body: TwinBody,
        renderer: Renderer,
        stage: FilmStage,
        cameras: Mapping[str, Camera],
        flaws: Flaws,
        seed: int = 0,
    ) -> None:
        self._body = body
        self._renderer = renderer
        self._stage = stage
        self._flaws = flaws
        self._rng = np.random.default_rng(seed)
        self._cameras = {name: misplaced(c, flaws, self._rng) for name, c in cameras.items()}
        self._drawing = threading.Lock()
        self._last: dict[tuple[str, bool], tuple[tuple[PlacedObject, ...], Frame]] = {}

    def joints(self) -> Reading:
        from probe_bridge.driver import Reading

        joints, stamp = self._body.joints()
        return Reading(tuple(joints.tolist()), stamp)

    def opening(self) -> float:
        return self._body.opening()

    def frame(self, camera: str, rgb: bool) -> Shot:
        from probe_bridge.driver import Shot

        with self._drawing:
            while self._rng.random() < self._flaws.dropped:
                time.sleep(_PERIOD)
            moment = self._body.moment()
            shown = self._with_robot(moment) if rgb else moment.objects
            clean = self._drawn(shown, camera, rgb=rgb)
            depth = noisy_depth(clean.depth, self._flaws, self._rng)
            colours = (
                noisy_colours(clean.rgb, self._flaws, self._rng) if clean.rgb is not None else None
            )
        time.sleep(self._flaws.latency)
        steps = np.clip(np.rint(depth / _UNIT), 0, 2**16 - 1).astype("<u2")
        height, width = depth.shape
        return Shot(width, height, steps.tobytes(), _UNIT, _bytes(colours), moment.stamp)

    def start(self, trajectory: Trajectory) -> None:
        self._body.start(trajectory)

    def poll(self) -> bool:
        return not self._body.moving()

    def start_grip(self, opening: float) -> None:
        self._body.grip(opening)

    def poll_grip(self) -> bool:
        return not self._body.gripping()

    def stop(self) -> None:
        self._body.stop()

    def close(self) -> None:
        self._body.close()

    def _with_robot(self, moment: TwinMoment) -> tuple[PlacedObject, ...]:
        """The things, and the robot unless it is parked, where no camera sees it."""
        parked = self._stage.setup.mount.parked
        if np.abs(moment.joints - parked).max() < PARKED:
            return moment.objects
        return (*moment.objects, *self._stage.placed(moment.joints, moment.opening))

    def _drawn(self, shown: tuple[PlacedObject, ...], camera: str, *, rgb: bool) -> Frame:
        """What a perfect camera there would show; drawn again only if something has moved."""
        known = self._last.get((camera, rgb))
        if known and known[0] == shown:
            return known[1]
        frame = self._renderer.draw(shown, self._cameras[camera], rgb=rgb)
        self._last[camera, rgb] = shown, frame
        return frame


def _bytes(colours: Array | None) -> bytes | None:
    return None if colours is None else colours.tobytes()
