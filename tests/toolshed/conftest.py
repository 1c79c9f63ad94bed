"""A painted table, its five tools, and skills that do as they are told."""

from __future__ import annotations

import pytest

from probe.perception.oracle import Oracle
from probe.scene.setup import UR5_TABLE
from probe.toolshed.toolshed import Toolshed
from tabletops import Block, Obedient, PaintedStation, spec

SPECS = {
    41: spec("red mug", "red"),
    42: spec("blue book", "blue"),
    43: spec("white ball", "white"),
    44: spec("green teapot", "green"),
}
BLOCKS = [
    Block(41, (100, 100, 219, 219)),
    Block(42, (500, 300, 799, 699), height=0.02, colour=(30, 60, 150)),
    Block(43, (600, 450, 679, 529), height=0.08, colour=(240, 240, 240)),
    Block(44, (560, 350, 575, 370), height=0.03, share=0.1, colour=(40, 120, 50)),
]


@pytest.fixture
def specs():
    return dict(SPECS)


@pytest.fixture
def station():
    return PaintedStation(BLOCKS)


@pytest.fixture
def skills():
    return Obedient()


@pytest.fixture
def shed(station, skills, specs):
    return Toolshed(station, Oracle(specs), skills, UR5_TABLE)
