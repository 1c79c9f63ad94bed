"""sensor_msgs/Image of ROS 1 and ROS 2 as the bridge's pictures. Knows no node."""

from __future__ import annotations

import sys
from array import array
from typing import Any, Optional, Tuple

from probe_bridge.driver import Shot

_MILLIMETRE = 1e-3
_FINE = 1e-4


def shot_of(depth: Any, colour: Optional[Any], stamp: float) -> Shot:
    """A picture from an Image of depth and one of colour, or None.

    Raises:
        ValueError: An encoding is unknown, or the two have different sizes.
    """
    if colour is not None and (colour.width, colour.height) != (depth.width, depth.height):
        raise ValueError(
            f"colour is {colour.width} x {colour.height}, depth {depth.width} x {depth.height};"
            " take the depth topic that is registered to colour"
        )
    values, unit = _depth_of(depth)
    rgb = None if colour is None else _rgb_of(colour)
    return Shot(depth.width, depth.height, values, unit, rgb, stamp)


def _rgb_of(image: Any) -> bytes:
    channels = {"rgb8": 3, "bgr8": 3, "rgba8": 4, "bgra8": 4}.get(image.encoding)
    if channels is None:
        raise ValueError(f"colour comes as {image.encoding!r}; rgb8 or bgr8 is needed")
    data = _packed(image, channels)
    first, third = (2, 0) if image.encoding.startswith("bgr") else (0, 2)
    rgb = bytearray(3 * image.width * image.height)
    rgb[0::3], rgb[1::3], rgb[2::3] = (
        data[first::channels],
        data[1::channels],
        data[third::channels],
    )
    return bytes(rgb)


def _depth_of(image: Any) -> Tuple[bytes, float]:
    """Depth in steps of the unit that comes second: millimetres as they are, metres in 0.1 mm."""
    if image.encoding in ("16UC1", "mono16"):
        return _little(array("H", _packed(image, 2)), image.is_bigendian), _MILLIMETRE
    if image.encoding != "32FC1":
        raise ValueError(f"depth comes as {image.encoding!r}; 16UC1 or 32FC1 is needed")
    metres = array("f", _packed(image, 4))
    if bool(image.is_bigendian) != (sys.byteorder == "big"):
        metres.byteswap()
    # NaN, infinite, negative and far values all mean that there is no depth.
    steps = array("H", (int(z / _FINE + 0.5) if 0.0 < z < 6.5 else 0 for z in metres))
    return _little(steps, sys.byteorder == "big"), _FINE


def _little(values: array[int], big: object) -> bytes:
    if big:
        values.byteswap()
    return values.tobytes()


def _packed(image: Any, size: int) -> bytes:
    """The pixels without what pads the rows."""
    data, row = bytes(image.data), image.width * size
    if image.step == row:
        return data
    return b"".join(data[y * image.step : y * image.step + row] for y in range(image.height))
