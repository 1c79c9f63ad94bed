"""The table's edge and legs, the arm's pedestal, the basket, and a room around them."""

from __future__ import annotations

from probe.assets.procedural.form.sheet import Sheet
from probe.scene.setup import FLOOR_DEPTH, Basket, Setup
from probe.stage.materials import plain
from probe.stage.part import StagePiece, piece
from probe.stage.solids import block
from probe.types import Array, Vector3

_METAL = plain((0.30, 0.31, 0.33), 0.5)
_STEEL = plain((0.62, 0.63, 0.65), 0.4, 1.0)
_PLASTIC = plain((0.86, 0.87, 0.88), 0.55)
_RIM = plain((0.22, 0.42, 0.62), 0.5)
_FLOOR = plain((0.60, 0.585, 0.56), 0.75)
_WALL = plain((0.83, 0.835, 0.83), 0.95)
_SKIRTING = plain((0.93, 0.93, 0.92), 0.6)

_SLAB = 0.045
"""Thickness of the table's top as it is drawn; the physics' is never seen from below."""

_LEG = 0.03
_BASKET_WALL = 0.01
_BEHIND = 1.6
"""How far behind the table's edges the walls stand."""

_ROOM = 2.6
"""Height of the walls."""


def furniture(setup: Setup, table_colour: Array) -> list[StagePiece]:
    """All that stands still, but for the room.

    Args:
        setup: The table, its basket and where its arm stands.
        table_colour: Of the table's edge, sRGB from 0 to 1, shape (3,).
    """
    return [*_table(setup, table_colour), *_pedestal(setup), *_basket(setup.basket)]


def _table(setup: Setup, colour: Array) -> list[StagePiece]:
    x, y = setup.table_size[0] / 2, setup.table_size[1] / 2
    # Just beneath the top, which has the table's own material.
    slab = block((0.0, 0.0, -_SLAB / 2 - 0.001), (x + 0.004, y + 0.004, _SLAB / 2), 0.004)
    half = (FLOOR_DEPTH - _SLAB) / 2
    legs = [
        block((sx * (x - 0.07), sy * (y - 0.07), -_SLAB - half), (_LEG, _LEG, half), 0.004)
        for sx in (-1, 1)
        for sy in (-1, 1)
    ]
    return [piece("world", plain(0.8 * colour, 0.6), slab), piece("world", _METAL, *legs)]


def _pedestal(setup: Setup) -> list[StagePiece]:
    x, y, height = setup.mount.base.position
    if height <= 0:
        return []
    half = height / 2
    plate = block((x, y, 0.006), (0.105, 0.105, 0.006), 0.002)
    return [
        piece("world", _METAL, block((x, y, half), (0.0745, 0.0745, half - 0.0005), 0.006)),
        piece("world", _STEEL, plate),
    ]


def _basket(basket: Basket) -> list[StagePiece]:
    """Its inner faces are the physics'."""
    x, y, z = basket.position
    length, width, height = basket.size
    half = _BASKET_WALL / 2
    floor = block((x, y, z + half), (length / 2, width / 2, half), 0.001)
    walls: list[list[Sheet]] = []
    rims: list[list[Sheet]] = []
    for sign in (-1, 1):
        east: Vector3 = (x + sign * (length / 2 + half), y, z + height / 2)
        north: Vector3 = (x, y + sign * (width / 2 + half), z + height / 2)
        walls.append(block(east, (half, width / 2 + _BASKET_WALL, height / 2), 0.003))
        walls.append(block(north, (length / 2 + _BASKET_WALL, half, height / 2), 0.003))
        top = z + height
        rims.append(block((*east[:2], top), (0.009, width / 2 + 0.014, 0.006), 0.004))
        rims.append(block((*north[:2], top), (length / 2 + 0.014, 0.009, 0.006), 0.004))
    return [piece("world", _PLASTIC, floor, *walls), piece("world", _RIM, *rims)]


def room(table: tuple[float, float]) -> list[StagePiece]:
    """A floor and the two walls behind the table, seen from the front right."""
    left, back = -table[0] / 2 - _BEHIND, table[1] / 2 + _BEHIND
    right, front = -left + 1.5, -back - 1.5
    middle_x, middle_y = (left + right) / 2, (front + back) / 2
    half_x, half_y = (right - left) / 2, (back - front) / 2
    level = _ROOM / 2 - FLOOR_DEPTH
    low = 0.05 - FLOOR_DEPTH
    return [
        piece(
            "world",
            _FLOOR,
            block((middle_x, middle_y, -FLOOR_DEPTH - 0.02), (half_x, half_y, 0.02), 0.001),
        ),
        piece(
            "world",
            _WALL,
            block((left - 0.05, middle_y, level), (0.05, half_y, _ROOM / 2), 0.001),
            block((middle_x, back + 0.05, level), (half_x, 0.05, _ROOM / 2), 0.001),
        ),
        piece(
            "world",
            _SKIRTING,
            block((left + 0.006, middle_y, low), (0.006, half_y, 0.05), 0.002),
            block((middle_x, back - 0.006, low), (half_x, 0.006, 0.05), 0.002),
        ),
    ]
