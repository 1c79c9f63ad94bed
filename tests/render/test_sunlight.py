"""The sun that is taken out of a panorama, and the exposure that is set."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from probe.render.illumination import Illumination, directions, solid_angles
from probe.render.sunlight import LOWEST, SHARES, WHITE, illuminate


def sky(azimuth: float, elevation: float, strength: float = 400.0, height: int = 64):
    """Grey all around, with one bright spot 3 degrees wide."""
    towards = directions(height)
    spot = np.array(
        [
            math.cos(elevation) * math.sin(azimuth),
            math.cos(elevation) * math.cos(azimuth),
            math.sin(elevation),
        ]
    )
    near = towards @ spot > math.cos(math.radians(3))
    return np.where(near[..., None], strength, 0.5) * np.ones(3), spot


def on_table(light: Illumination):
    """Irradiance over pi of an upward surface, from the panorama and from the sun."""
    assert light.sun is not None
    height = light.radiance.shape[0]
    weight = np.maximum(directions(height)[..., 2], 0) * solid_angles(height)
    around = np.einsum("hw,hwc->c", weight, light.radiance.astype(float)) / np.pi
    return around, np.array(light.sun.irradiance) * light.sun.towards[2]


@given(azimuth=st.floats(-3, 3), elevation=st.floats(0.1, 1.4), yaw=st.floats(-6, 6))
def test_the_sun_follows_the_brightest_spot_and_the_yaw(azimuth, elevation, yaw):
    light = illuminate(sky(azimuth, elevation)[0], yaw)
    assert light.sun is not None
    x, y, z = light.sun.towards
    # Azimuths run clockwise from +y, a yaw anticlockwise.
    error = (math.atan2(x, y) - (azimuth - yaw) + math.pi) % (2 * math.pi) - math.pi
    assert abs(error) * math.cos(elevation) < math.radians(6)
    assert math.asin(z) == pytest.approx(max(elevation, LOWEST), abs=math.radians(4))


@given(strength=st.floats(1, 1e5), elevation=st.floats(0.05, 1.5))
def test_shares_and_exposure_are_lawful(strength, elevation):
    light = illuminate(sky(0.3, elevation, strength)[0], 0.0)
    around, sun = on_table(light)
    share = sun.mean() / (sun + around).mean()
    assert SHARES[0] - 0.02 <= share <= SHARES[1] + 0.02
    assert (sun + around).max() == pytest.approx(WHITE, rel=0.02)


def test_an_even_sky_has_a_weak_sun():
    light = illuminate(np.full((32, 64, 3), 2.0), 0.0)
    around, sun = on_table(light)
    assert sun.mean() / (sun + around).mean() == pytest.approx(SHARES[0], abs=0.02)


def test_the_backdrop_keeps_its_bright_spot():
    panorama, _ = sky(0.0, 0.8)
    light = illuminate(panorama, 0.0)
    assert light.backdrop is not None
    ratio = light.backdrop.astype(float).max() / light.backdrop.astype(float).min()
    assert ratio == pytest.approx(800, rel=0.01)
    assert light.radiance.max() < 0.01 * light.backdrop.max()
