"""Images of ROS, with all that their encodings allow."""

from __future__ import annotations

import array
import struct
from types import SimpleNamespace
from typing import Any

import pytest

from probe_bridge.drivers.ros_images import shot_of


def image(encoding: str, size: int, data: bytes, width: int = 2, pad: int = 0, big: int = 0) -> Any:
    height = len(data) // (width * size)
    rows = [data[y * width * size : (y + 1) * width * size] for y in range(height)]
    return SimpleNamespace(
        width=width,
        height=height,
        encoding=encoding,
        step=width * size + pad,
        is_bigendian=big,
        data=array.array("B", b"".join(row + bytes(pad) for row in rows)),
    )


def values(shot: Any) -> list[int]:
    return list(struct.unpack(f"<{shot.width * shot.height}H", shot.depth))


def test_millimetres_stay_and_padding_goes():
    data = struct.pack("<4H", 1, 2, 700, 65535)
    shot = shot_of(image("16UC1", 2, data, pad=3), None, 5.0)
    assert values(shot) == [1, 2, 700, 65535]
    assert (shot.depth_unit, shot.rgb, shot.stamp) == (0.001, None, 5.0)


def test_big_endian_depth_is_turned():
    shot = shot_of(image("16UC1", 2, struct.pack(">2H", 1, 700), big=1), None, 0.0)
    assert values(shot) == [1, 700]


def test_metres_become_tenths_of_millimetres_and_holes_become_zero():
    metres = (0.5, float("nan"), float("inf"), -1.0, 0.12345, 9.0)
    shot = shot_of(image("32FC1", 4, struct.pack("<6f", *metres)), None, 0.0)
    assert values(shot) == [5000, 0, 0, 0, 1235, 0]
    assert shot.depth_unit == 0.0001


@pytest.mark.parametrize(
    ("encoding", "pixel"),
    [("rgb8", (1, 2, 3)), ("bgr8", (3, 2, 1)), ("rgba8", (1, 2, 3, 9)), ("bgra8", (3, 2, 1, 9))],
)
def test_colours_become_rgb(encoding: str, pixel: Any):
    depth = image("16UC1", 2, bytes(8))
    shot = shot_of(depth, image(encoding, len(pixel), bytes(pixel) * 4, pad=1), 0.0)
    assert shot.rgb == bytes((1, 2, 3)) * 4


def test_what_is_not_known_or_not_registered_is_refused():
    depth = image("16UC1", 2, bytes(8))
    with pytest.raises(ValueError, match="yuv422"):
        shot_of(depth, image("yuv422", 2, bytes(8)), 0.0)
    with pytest.raises(ValueError, match="registered"):
        shot_of(depth, image("rgb8", 3, bytes(6)), 0.0)
    with pytest.raises(ValueError, match="8UC1"):
        shot_of(image("8UC1", 1, bytes(4)), None, 0.0)
