"""How a UR5 looks: tubes of aluminium, joint housings with flat blue caps, dark seals between them.

Our own shapes, within the solids that the physics has (world/robot/ur5_body.py) to 2 mm; each in
the frame of its link.
"""

from __future__ import annotations

from probe.assets.procedural.form.sheet import Sheet
from probe.stage.materials import plain
from probe.stage.part import StagePiece, piece
from probe.stage.solids import drum, turned
from probe.types import Vector3

_PAINT = plain((0.78, 0.79, 0.80), 0.42)
_CAP = plain((0.40, 0.62, 0.78), 0.38)
_SEAL = plain((0.13, 0.13, 0.14), 0.7)
_STEEL = plain((0.66, 0.67, 0.69), 0.35, 1.0)

_UPPER, _FORE = -0.425, -0.39225
"""Where the far ends of the two long links lie along their x, metres."""


def ur5_pieces() -> list[StagePiece]:
    """The arm without its hand."""
    return [*_base(), *_shoulder(), *_upper_arm(), *_forearm(), *_wrists()]


def _place(axis: int, along: float, x: float) -> Vector3:
    return (x, along, 0.0) if axis == 1 else (x, 0.0, along)


def _housing(
    axis: int, start: float, end: float, radius: float, x: float = 0.0, fillet: float = 0.006
) -> Sheet:
    """A drum about axis 1 (y) or 2 (z) of the link, displaced along its x."""
    return drum(_place(axis, start, x), _place(axis, end, x), radius, fillet)


def _seal(axis: int, at: float, radius: float, x: float = 0.0) -> Sheet:
    """A dark ring where two links meet."""
    return drum(_place(axis, at - 0.0025, x), _place(axis, at + 0.0025, x), radius, 0.0008)


def _cap(axis: int, start: float, end: float, radius: float, x: float = 0.0) -> Sheet:
    """A flat lid with a rounded rim and a shallow groove, from `start` outwards."""
    height = abs(end - start)
    rim = [(radius, 0.0, 0.0), (radius, height, 0.7 * height)]
    groove = [(0.80 * radius, height, 0.0), (0.79 * radius, height - 0.0015, 0.0)]
    middle = [(0.76 * radius, height - 0.0015, 0.0), (0.75 * radius, height, 0.0)]
    profile = [(0.0, 0.0, 0.0), *rim, *groove, *middle, (0.0, height, 0.0)]
    return turned(profile, _place(axis, start, x), _place(axis, end, x))


def _tube(z: float, x: float, radius: float, collar: float) -> Sheet:
    """The long part of a link, wider where it meets its housings."""
    length = abs(x)
    profile = [
        (0.0, 0.0, 0.0),
        (collar, 0.0, 0.0),
        (collar, 0.085, 0.02),
        (radius, 0.105, 0.02),
        (radius, length - 0.105, 0.02),
        (collar, length - 0.085, 0.02),
        (collar, length, 0.0),
        (0.0, length, 0.0),
    ]
    return turned(profile, (0.0, 0.0, z), (x, 0.0, z))


def _base() -> list[StagePiece]:
    return [
        piece("arm_base", _STEEL, drum((0.0, 0.0, 0.0), (0.0, 0.0, 0.011), 0.0745, 0.002)),
        piece("arm_base", _PAINT, drum((0.0, 0.0, 0.011), (0.0, 0.0, 0.026), 0.073, 0.005)),
    ]


def _shoulder() -> list[StagePiece]:
    return [
        piece("shoulder", _PAINT, _housing(2, -0.061, 0.062, 0.06), _housing(1, -0.066, 0.0, 0.06)),
        piece("shoulder", _CAP, _cap(2, 0.061, 0.0685, 0.057)),
        piece("shoulder", _SEAL, _seal(2, -0.0625, 0.0585), _seal(1, -0.0675, 0.0585)),
    ]


def _upper_arm() -> list[StagePiece]:
    ends = (0.0, _UPPER)
    return [
        piece(
            "upper_arm",
            _PAINT,
            _tube(0.13585, _UPPER, 0.0445, 0.052),
            [_housing(2, 0.073, 0.197, 0.06, x) for x in ends],
        ),
        piece("upper_arm", _CAP, [_cap(2, 0.196, 0.204, 0.056, x) for x in ends]),
        piece("upper_arm", _SEAL, _seal(2, 0.0725, 0.0585, _UPPER)),
    ]


def _forearm() -> list[StagePiece]:
    return [
        piece(
            "forearm",
            _PAINT,
            _tube(0.0165, _FORE, 0.0355, 0.0385),
            _housing(2, -0.025, 0.068, 0.058, fillet=0.014),
            _housing(2, -0.034, 0.060, 0.039, _FORE),
        ),
        piece("forearm", _CAP, _cap(2, -0.033, -0.041, 0.0365, _FORE)),
        piece("forearm", _SEAL, _seal(2, 0.0605, 0.038, _FORE)),
    ]


def _wrists() -> list[StagePiece]:
    # One drum ends within the other: two of one radius would show through each other.
    first, second = _housing(2, -0.043, 0.0, 0.039), _housing(2, -0.042, 0.0, 0.039)
    return [
        piece("wrist_1", _PAINT, first, _housing(1, -0.045, 0.052, 0.0392)),
        piece("wrist_1", _CAP, _cap(1, 0.0505, 0.057, 0.0365)),
        piece("wrist_1", _SEAL, _seal(1, -0.0465, 0.038)),
        piece("wrist_2", _PAINT, second, _housing(1, -0.052, 0.045, 0.0392)),
        piece("wrist_2", _CAP, _cap(1, -0.0505, -0.057, 0.0365)),
        piece("wrist_2", _SEAL, _seal(2, -0.0445, 0.038), _seal(1, 0.0465, 0.038)),
        piece("wrist_3", _STEEL, _housing(2, -0.033, 0.0, 0.0372)),
    ]
