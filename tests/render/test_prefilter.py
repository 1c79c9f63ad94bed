"""Image-based light against integrals worked out here, and known answers."""

import numpy as np
import pytest

from probe.assets.cache import Cache
from probe.render.illumination import AMBIENT, directions, solid_angles
from probe.render.ktx import packed_floats
from probe.render.light_packing import LightPacker
from probe.render.prefilter import face_directions, harmonics, look_up
from probe.render.sunlight import illuminate


def irradiance(bands, normal):
    """Filament's sum over nine polynomials of cube directions (x, z, -y)."""
    x, y, z = normal[0], normal[2], -normal[1]
    terms = [1, y, z, x, y * x, y * z, 3 * z * z - 1, z * x, x * x - y * y]
    return np.array(terms) @ bands


@pytest.mark.parametrize("normal", [(0, 0, 1), (1, 0, 0), (0, -1, 0), (0.6, 0, 0.8)])
def test_harmonics_give_the_irradiance_of_a_smooth_sky(normal):
    towards = directions(64)
    panorama = 1 + 0.5 * towards + 0.3 * towards[..., :1] * towards[..., 2:]
    weight = np.maximum(towards @ np.array(normal), 0) * solid_angles(64)
    expected = np.einsum("hw,hwc->c", weight, panorama) / np.pi
    found = irradiance(harmonics(panorama.astype(np.float16)), np.array(normal, float))
    assert found == pytest.approx(expected, rel=0.02)


def test_a_direction_finds_its_own_pixel():
    panorama = np.random.default_rng(1).random((16, 32, 3)).astype(np.float32)
    assert look_up(panorama, directions(16)) == pytest.approx(panorama, abs=1e-3)


def test_faces_look_along_their_axes():
    outwards = face_directions(3)[:, 1, 1]
    # Cube +X -X +Y -Y +Z -Z are the world's +x -x +z -z -y +y.
    expected = [(1, 0, 0), (-1, 0, 0), (0, 0, 1), (0, 0, -1), (0, -1, 0), (0, 1, 0)]
    assert outwards == pytest.approx(np.array(expected, float))


def test_packed_floats_are_the_specification_s():
    # EXT_packed_float: 1.0 has the exponent 15; six and five bits of mantissa.
    assert packed_floats(np.ones(3)) == 15 << 6 | 15 << 6 << 11 | 15 << 5 << 22
    assert packed_floats(np.array([-1.0, 0.0, 1e9])) == 0x3FF << 22 & 0xFFFFFFFF & (991 << 22)


def test_prefiltered_light_is_kept_by_content(tmp_path):
    panorama = np.random.default_rng(2).random((16, 32, 3))
    light, other = illuminate(panorama, 0.0), illuminate(panorama, 1.0)
    first = LightPacker(Cache(tmp_path)).pack(light)
    assert len(list(tmp_path.rglob("*.npz"))) == 1
    packer = LightPacker(Cache(tmp_path))
    assert packer.pack(light).around == first.around
    assert packer.pack(light) is packer.pack(light)
    assert packer.pack(other).around != first.around
    assert len(list(tmp_path.rglob("*.npz"))) == 2
    assert packer.pack(AMBIENT).backdrop is None and first.backdrop is not None


def test_ambient_light_is_exactly_one_everywhere():
    file = LightPacker().pack(AMBIENT).around
    bands = file[file.index(b"sh\0") + 3 :].split(b"\0")[0].decode().split("\n")[:9]
    assert [[float(v) for v in band.split()] for band in bands] == [[1.0] * 3] + [[0.0] * 3] * 8
    one = (15 << 6 | 15 << 6 << 11 | 15 << 5 << 22).to_bytes(4, "little")
    assert file.endswith(6 * one) and file.count(one) >= 6 * (256 + 64 + 16 + 4 + 1)
