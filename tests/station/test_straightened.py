"""Any pinhole camera's picture, looked up as a square, centred one."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from probe_bridge.config import BridgeCamera
from probe_bridge.description import Picture

from probe.errors import BadData
from probe.station.straightened import Straightened

PLACE, TURNED = (0.1, -0.9, 0.5), (0.5, -0.5, 0.5, -0.5)


def picture(camera: BridgeCamera, depth: np.ndarray, rgb: np.ndarray) -> Picture:
    return Picture(camera, depth.astype("<u2").tobytes(), 1e-4, rgb.astype(np.uint8).tobytes(), 0.0)


@given(
    width=st.integers(80, 200),
    height=st.integers(60, 150),
    focal=st.floats(60, 200),
    squeeze=st.floats(0.8, 1.25),
    aside=st.tuples(st.floats(-15, 15), st.floats(-10, 10)),
)
def test_each_pixel_shows_what_lies_in_its_direction(width, height, focal, squeeze, aside) -> None:
    fx, fy = focal, focal * squeeze
    cx, cy = width / 2 + aside[0], height / 2 + aside[1]
    camera = BridgeCamera("front", width, height, fx, fy, cx, cy, PLACE, TURNED)
    across = np.tile((np.arange(width) + 0.5 - cx) / fx, (height, 1))
    along = np.tile(((np.arange(height) + 0.5 - cy) / fy)[:, None], (1, width))
    colours = np.stack([128 + 60 * across, 128 + 60 * along, 0 * across], axis=-1)
    seen = picture(camera, 20000 + 5000 * across, np.clip(colours, 0, 255))
    straight = Straightened.of(camera, 64)
    n = 64
    uv = np.stack(np.meshgrid(np.arange(n) + 0.5, np.arange(n) + 0.5), axis=-1).reshape(-1, 2)
    rays = straight.camera.rays(uv).reshape(n, n, 3)
    # Half a pixel of the real picture, and a step of what is counted in.
    assert np.abs(straight.depth(seen) - (2 + 0.5 * rays[..., 0])).max() < 0.26 / fx + 2e-4
    inner = straight.rgb(seen)[1:-1, 1:-1].astype(float)
    wanted = np.clip(128 + 60 * rays[1:-1, 1:-1, :2], 0, 255)
    assert np.abs(inner[..., :2] - wanted).max() < 1.6
    # All of the square is in the picture.
    half = math.tan(math.radians(straight.camera.fov_y_deg) / 2)
    assert cx - half * fx > -1e-6 and cx + half * fx < width + 1e-6
    assert cy - half * fy > -1e-6 and cy + half * fy < height + 1e-6


def test_a_square_centred_picture_comes_through_unchanged() -> None:
    camera = BridgeCamera("top", 64, 64, 70.0, 70.0, 32.0, 32.0, PLACE, TURNED)
    rng = np.random.default_rng(3)
    depth, rgb = rng.integers(0, 2**16, (64, 64)), rng.integers(0, 256, (64, 64, 3))
    straight = Straightened.of(camera, 64)
    seen = picture(camera, depth, rgb)
    assert (straight.rgb(seen) == rgb).all()
    assert np.allclose(straight.depth(seen), depth * 1e-4)


def test_a_principal_point_beside_the_picture_is_refused() -> None:
    camera = BridgeCamera("front", 64, 48, 70.0, 70.0, 2.0, 24.0, PLACE, TURNED)
    with pytest.raises(BadData, match=r"camera front: its principal point \(2\.0, 24\.0\)"):
        Straightened.of(camera, 64)
