"""The same object on another machine is the same; an object that was changed isn't."""

import subprocess
import sys
from dataclasses import replace

import numpy as np
import pytest

from probe.assets.mesh.fingerprint import fingerprint, same
from probe.assets.mesh.mesh import Body, ConvexPiece
from shapes import box

MESH = box(0.1, 0.1, 0.1, 200, 0, 0)
PIECE = ConvexPiece(MESH.vertices.astype(float))
BODY = Body(MESH, (PIECE,))

_HERE = """
from pathlib import Path
from probe.assets.mesh.fingerprint import fingerprint
from probe.assets.procedural.catalogue import build
for name in ("proc_green_mug", "proc_croissant", "proc_red_apple"):
    print(*fingerprint(build(name)))
"""


@pytest.mark.parametrize(
    "other",
    [
        Body(MESH, (ConvexPiece(PIECE.vertices * 1.001),)),
        Body(MESH, (PIECE, PIECE)),
        Body(box(0.1, 0.1, 0.1, 201, 0, 0), (PIECE,)),
        Body(replace(MESH, vertices=MESH.vertices * np.float32(1.001)), (PIECE,)),
        Body(replace(MESH, surface=replace(MESH.surface, roughness=0.1)), (PIECE,)),
    ],
)
def test_a_change_that_shows_is_noticed(other):
    assert not same(fingerprint(BODY), fingerprint(other))


def test_the_last_bits_play_no_part():
    shaken = np.nextafter(MESH.vertices, np.float32(1))
    pieces = (ConvexPiece(PIECE.vertices + 1e-9),)
    assert same(fingerprint(BODY), fingerprint(Body(replace(MESH, vertices=shaken), pieces)))


@pytest.mark.slow
def test_another_type_of_processor_makes_the_same_objects(monkeypatch):
    def made() -> list[tuple[float, ...]]:
        told = subprocess.run(
            [sys.executable, "-W", "ignore", "-c", _HERE],
            capture_output=True,
            text=True,
            check=True,
        )
        return [tuple(map(float, line.split())) for line in told.stdout.splitlines()]

    here = made()
    # Fewer vector instructions: sums and sines round differently, as on an older machine.
    monkeypatch.setenv("NPY_DISABLE_CPU_FEATURES", "X86_V4 X86_V3 AVX512F AVX2 FMA3")
    there = made()
    assert len(here) == 3 and all(same(a, b) for a, b in zip(here, there, strict=True))
