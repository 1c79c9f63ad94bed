"""Where a film is seen from: cameras that no agent has."""

from __future__ import annotations

import numpy as np

from probe.scene.setup import Setup
from probe.types import Camera, Vector3, looking_at

FAR = 14.0
"""How far they see, metres: to the walls and a bit."""

_TOWARDS: Vector3 = (0.63, -0.60, 0.40)
"""From what is looked at to the camera."""

AWAY = 2.15
"""Metres from there to the middle of what a film shows."""

_FOV_DEG = 36.0


def whole_view(setup: Setup, width_px: int, height_px: int) -> Camera:
    """Arm, basket and the middle of the table, obliquely from the front."""
    return _seen(_middle(setup), AWAY, width_px, height_px)


def _middle(setup: Setup) -> Vector3:
    """Between the arm's base, the basket and the work area, and a little above the table."""
    arm, basket = setup.mount.base.position, setup.basket.position
    x, y = (np.array(arm[:2]) + np.array(basket[:2])) / 4
    return float(x) + 0.06, float(y) + 0.02, 0.20


def _seen(target: Vector3, away: float, width_px: int, height_px: int) -> Camera:
    middle = np.array(target)
    eye = middle + away * np.array(_TOWARDS) / np.linalg.norm(_TOWARDS)
    return Camera(looking_at(eye, middle), width_px, height_px, _FOV_DEG)
