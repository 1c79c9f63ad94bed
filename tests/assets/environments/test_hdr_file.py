import numpy as np
import OpenEXR
import pytest

from probe.assets.environments.hdr_file import read_panorama
from probe.errors import BadData

HEAD = b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n"


def flat(height: int, width: int, rgbe: bytes) -> bytes:
    return HEAD + b"-Y %d +X %d\n" % (height, width) + rgbe * (height * width)


def coded(height: int, width: int, rgbe: bytes) -> bytes:
    """Rows of runs: half of each channel as one run, half byte by byte."""
    half = width // 2
    row = bytes((2, 2, width >> 8, width & 255))
    for value in rgbe:
        row += bytes((128 + half, value, half)) + bytes([value]) * half
    return HEAD + b"-Y %d +X %d\n" % (height, width) + row * height


@pytest.mark.parametrize("layout", [flat, coded])
def test_shared_exponents_are_radiance(tmp_path, layout):
    path = tmp_path / "one.hdr"
    # Ward: value = mantissa / 256 * 2^(exponent - 128).
    path.write_bytes(layout(8, 16, bytes((128, 64, 32, 131))))
    radiance = read_panorama(path)
    assert radiance.shape == (8, 16, 3) and radiance.dtype == np.float32
    assert (radiance == np.array([4.0, 2.0, 1.0])).all()


def test_an_exr_file_is_read(tmp_path):
    path = tmp_path / "one.exr"
    pixels = np.random.default_rng(0).random((8, 16, 3), np.float32)
    OpenEXR.File({"type": OpenEXR.scanlineimage}, {"RGB": pixels}).write(str(path))
    assert (read_panorama(path) == pixels).all()


BAD = {
    "cut short": coded(8, 16, b"\x80\x40\x20\x83")[:-9],
    "no picture": b"GIF89a",
    "square": flat(16, 16, b"\x80\x40\x20\x83"),
    "huge": HEAD + b"-Y 400000 +X 800000\n",
    "dark": flat(8, 16, b"\0\0\0\0"),
    "empty": b"",
}


@pytest.mark.parametrize("content", BAD.values(), ids=list(BAD))
@pytest.mark.parametrize("ending", ["hdr", "exr"])
def test_a_spoiled_file_is_named(tmp_path, content, ending):
    path = tmp_path / f"odd.{ending}"
    path.write_bytes(content)
    with pytest.raises(BadData, match=rf"odd\.{ending}"):
        read_panorama(path)


def test_all_panoramas_of_the_assets_are_read(assets):
    files = sorted((assets / "hdris").glob("*.hdr"))
    assert files
    for path in files[:3]:
        assert read_panorama(path).shape == (512, 1024, 3)
