"""How a Robotiq 2F-140 looks: a dark body, cranked fingers, rubber pads.

Our own shapes, within the boxes that the physics has (world/robot/gripper_shape.py); the pads are
those boxes. Each in the frame of its part at the finger on the -y side; the other finger's frames
are turned about z, so that both wear the same.
"""

from __future__ import annotations

from probe.assets.procedural.form.sheet import Sheet
from probe.scene.setup import GripperSize
from probe.stage.materials import plain
from probe.stage.part import StagePiece, piece
from probe.stage.solids import bar, block, drum, turned
from probe.types import Vector3
from probe.world.robot.gripper import INNER_PIVOT, PIVOT, crank
from probe.world.robot.gripper_shape import pad

_BODY = plain((0.10, 0.10, 0.11), 0.45)
_SHELL = plain((0.24, 0.245, 0.26), 0.4)
_STEEL = plain((0.68, 0.69, 0.71), 0.32, 1.0)
_RUBBER = plain((0.17, 0.17, 0.18), 0.9)

_INNER_END: Vector3 = (0.0, PIVOT[0] - INNER_PIVOT[0], INNER_PIVOT[1] - PIVOT[1])
"""Where the inner crank meets the inner finger, in the finger's frame."""


def gripper_pieces(size: GripperSize) -> list[StagePiece]:
    """The hand."""
    pieces = _palm()
    for side in ("left", "right"):
        pieces += [*_outer_crank(side, size), *_inner_crank(side, size), *_finger(side, size)]
    return pieces


def _pin(centre: Vector3, half: float, radius: float) -> Sheet:
    """A bolt along x."""
    _, y, z = centre
    return drum((-half, y, z), (half, y, z), radius, 0.001)


def _palm() -> list[StagePiece]:
    body = [(0.0, 0.012, 0.0), (0.0365, 0.012, 0.0), (0.0375, 0.018, 0.003), (0.0365, 0.044, 0.006)]
    profile = [*body, (0.026, 0.05, 0.003), (0.0, 0.05, 0.0)]
    pivots = [(0.0, sign * y, z) for sign in (-1, 1) for y, z in (PIVOT, INNER_PIVOT)]
    return [
        piece("palm", _STEEL, drum((0.0, 0.0, 0.0), (0.0, 0.0, 0.011), 0.0375, 0.0015)),
        piece("palm", _BODY, turned(profile, (0.0, 0.0, 0.0), (0.0, 0.0, 1.0))),
        piece(
            "palm",
            _SHELL,
            block((0.0, 0.0, 0.057), (0.0118, 0.0405, 0.0125), 0.004),
            block((0.0, 0.0, 0.078), (0.0100, 0.0230, 0.0105), 0.004),
        ),
        piece("palm", _STEEL, [_pin(pivot, 0.0125, 0.0045) for pivot in pivots]),
    ]


def _outer_crank(side: str, size: GripperSize) -> list[StagePiece]:
    length = crank(size)
    share = length / 0.1
    path: list[Vector3] = [
        (0.0, 0.0, -0.004),
        (0.0, -0.010, 0.022 * share),
        (0.0, -0.0155, 0.046 * share),
        (0.0, -0.0130, 0.070 * share),
        (0.0, 0.0, length + 0.003),
    ]
    frame = f"{side}_outer_crank"
    return [
        piece(frame, _BODY, bar(path, (0.0115, 0.0082), 0.004)),
        piece(frame, _STEEL, _pin((0.0, 0.0, 0.0), 0.0135, 0.006)),
        piece(frame, _STEEL, _pin((0.0, 0.0, length), 0.0128, 0.0045)),
    ]


def _inner_crank(side: str, size: GripperSize) -> list[StagePiece]:
    """Two thin plates beside the outer crank's plane."""
    length = crank(size)
    plates = [
        block((x, 0.0, length / 2), (0.0012, 0.0055, length / 2 + 0.005), 0.001)
        for x in (-0.0135, 0.0135)
    ]
    frame = f"{side}_inner_crank"
    return [
        piece(frame, _SHELL, *plates),
        piece(frame, _STEEL, _pin((0.0, 0.0, 0.0), 0.0150, 0.0035)),
        piece(frame, _STEEL, _pin((0.0, 0.0, length), 0.0150, 0.0035)),
    ]


def _finger(side: str, size: GripperSize) -> list[StagePiece]:
    rubber = pad(size)
    _, y, z = rubber.centre
    back = y - rubber.half_size[1]
    frame = f"{side}_finger"
    return [
        piece(
            frame,
            _BODY,
            bar(
                [(0.0, -0.001, -0.003), _INNER_END, (0.0, back - 0.004, z)], (0.0075, 0.0065), 0.003
            ),
            block((0.0, back - 0.0030, z), (0.0118, 0.0030, rubber.half_size[2] - 0.001), 0.002),
        ),
        piece(frame, _RUBBER, block(rubber.centre, rubber.half_size, 0.0015)),
    ]
