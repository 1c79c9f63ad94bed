"""Convex pieces against the mesh that one sees, and cavities against a ball dropped in."""

from functools import cache, lru_cache

import numpy as np
import pytest
import trimesh
from scipy.spatial import ConvexHull, cKDTree

from probe.assets.procedural.catalogue import assemble, first_of_each_shape, rng_of
from probe.assets.procedural.form.sheet import Sheet
from probe.assets.procedural.parts.hollow import Hollow
from probe.assets.procedural.tables import ProceduralEntry
from probe.types import Array

TIGHT = 0.003
PROUD = 0.004
FEW = ("mug", "salad_bowl", "hat", "tray", "own goblet", "own hard hat", "own ladle")
SOME = ("mug", "bowl", "tray", "banana", "book", "can", "apple")


SHARES = 24
"""All shapes are checked in so many tests."""


@cache
def pieces_of(shape: str) -> list[Array]:
    return assemble(first_of_each_shape()[shape])[1]


@cache
def hulls_of(shape: str) -> list[ConvexHull]:
    return [ConvexHull(corners) for corners in pieces_of(shape)]


@lru_cache(maxsize=2)  # meshes keep what traces their rays, which dies where there are thousands
def closed_parts(shape: str) -> list[tuple[trimesh.Trimesh, bool]]:
    """Each part's closed surface, at rest, and whether it has convex pieces."""
    entry = first_of_each_shape()[shape]
    sheets = [sheet for sheet, _ in assemble(entry)[0]]
    found: list[tuple[trimesh.Trimesh, bool]] = []
    for k, part in enumerate(entry.parts):
        count = len(part.placed_surfaces(rng_of(f"{entry.shape} {k}")))
        found.append((joined(sheets[:count]), part.solid))
        sheets = sheets[count:]
    return found


def joined(sheets: list[Sheet]) -> trimesh.Trimesh:
    points = [sheet.points.reshape(-1, 3) for sheet in sheets]
    starts = np.cumsum([0, *(len(p) for p in points)])
    faces = [sheet.faces + k for sheet, k in zip(sheets, starts[:-1], strict=True)]
    return trimesh.Trimesh(np.vstack(points), np.vstack(faces), process=False)


@pytest.mark.parametrize("shape", SOME)
def test_each_piece_is_convex_and_small_enough(shape: str) -> None:
    pieces = pieces_of(shape)
    assert 1 <= len(pieces) <= 40
    for corners, hull in zip(pieces, hulls_of(shape), strict=True):
        assert corners.dtype == np.float64
        assert 4 <= len(corners) <= 64
        assert len(hull.vertices) == len(corners)
        assert trimesh.convex.convex_hull(corners).is_watertight
        assert hull.volume > 1e-9


@pytest.mark.parametrize("shape", SOME)
def test_pieces_cover_the_mesh(shape: str) -> None:
    planes = [hull.equations for hull in hulls_of(shape)]
    for mesh, solid in closed_parts(shape):
        if solid:
            outside = [(mesh.vertices @ p[:, :3].T + p[:, 3]).max(axis=1) for p in planes]
            assert np.min(outside, axis=0).max() < TIGHT


@pytest.mark.parametrize("shape", SOME)
def test_pieces_keep_to_the_mesh(shape: str) -> None:
    samples = np.vstack(
        [trimesh.convex.convex_hull(c).sample(300, seed=0) for c in pieces_of(shape)]
    )
    for mesh, _ in closed_parts(shape):
        samples = samples[~mesh.ray.contains_points(samples)]
    whole = trimesh.util.concatenate([mesh for mesh, _ in closed_parts(shape)])
    spread = trimesh.sample.sample_surface(whole, 20_000, seed=1)[0]
    nearest = cKDTree(spread).query(samples)[0]
    # Measured between points, which is never too little; exactly where that is too much.
    doubtful = samples[nearest > PROUD]
    if len(doubtful):
        exact = [
            trimesh.proximity.closest_point_naive(mesh, doubtful)[1]
            for mesh, _ in closed_parts(shape)
        ]
        assert np.min(exact, axis=0).max() < PROUD


def cavity_of(entry: ProceduralEntry) -> Hollow:
    return next(part for part in entry.parts if isinstance(part, Hollow))


def is_closed(entry: ProceduralEntry) -> bool:
    """Whether its cavity is one turned part with a floor, unlike a funnel's or a crate's."""
    hollow = any(isinstance(part, Hollow) for part in entry.parts)
    return hollow and cavity_of(entry).inner[0][0] == 0


@pytest.mark.parametrize("shape", FEW)
def test_a_ray_down_the_cavity_meets_its_floor(shape: str) -> None:
    entry = first_of_each_shape()[shape]
    profile = cavity_of(entry)
    low = min(row[1] for row in profile.outer)
    base, floor, rim = (
        (row[1] - low) * entry.scale
        for row in (profile.outer[0], profile.inner[0], profile.inner[-1])
    )
    mouth_down = profile.place.turn[0] == 180
    parts = closed_parts(shape)
    cavity = next(m for (m, _), p in zip(parts, entry.parts, strict=True) if p is profile)
    middle = cavity.bounds.mean(axis=0)[:2]
    planes = [hull.equations for hull in hulls_of(shape)]
    bottom, top = cavity.bounds[:, 2]
    # Heights at which the middle of the cavity is free: from just above the floor to the rim.
    free = np.linspace(floor + 0.003, rim, 30)
    heights = top - free if mouth_down else bottom + free
    points = np.column_stack([np.tile(middle, (30, 1)), heights])
    filled = [(points @ p[:, :3].T + p[:, 3]).max(axis=1) < 0 for p in planes]
    assert not np.any(filled)
    under = (base + floor) / 2
    point = np.array([*middle, top - under if mouth_down else bottom + under])
    assert any((p[:, :3] @ point + p[:, 3]).max() < 0.001 for p in planes)


def check_share(share: int, subtests: pytest.Subtests) -> None:
    """All that holds for any shape, of every 24th from one on."""
    for shape, entry in list(first_of_each_shape().items())[share::SHARES]:
        with subtests.test(shape):
            test_each_piece_is_convex_and_small_enough(shape)
            test_pieces_cover_the_mesh(shape)
            test_pieces_keep_to_the_mesh(shape)
            if entry.hollow and is_closed(entry):
                test_a_ray_down_the_cavity_meets_its_floor(shape)


@pytest.mark.slow
def test_a_share_of_all_shapes(subtests: pytest.Subtests) -> None:
    check_share(0, subtests)


@pytest.mark.slow
@pytest.mark.every_object
@pytest.mark.parametrize("share", range(1, SHARES))
def test_all_other_shapes(share: int, subtests: pytest.Subtests) -> None:
    check_share(share, subtests)
