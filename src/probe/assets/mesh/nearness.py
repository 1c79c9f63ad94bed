"""How alike two objects are: by shape, by a fit of one onto the other, and by texture."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from scipy.ndimage import gaussian_filter
from scipy.spatial.distance import pdist

from probe.assets.colour.names import lab
from probe.assets.mesh.alignment import misfit
from probe.assets.mesh.lattice import colours_at, places, spots
from probe.assets.mesh.mesh import TexturedMesh
from probe.types import Array

SAME_FIT = 0.05
"""Misfit, by the mean distance in the object, of what is one shape whatever its colours.

Two samples of one shape with 800 spots each lie 0.04 apart. Among 198 objects (165 scans, 21 BOP
models, 12 Gazebo folders) 30 pairs are the same object twice and come out at up to 0.042. Up to
0.05 there are, besides, 13 pairs of one series in other colours (cups, markers, figures, towels),
screwdrivers, two bottles, and fork and knife; above come two makes of scissors (0.053), then a
plum and a ball."""

CLOSE_FIT = 0.075
CLOSE_TEXTURE = 0.3
"""What fits worse is a near-duplicate if its colours are alike, too: a toy aeroplane in two states,
a cup with and without its handle. The next pair would be a can opener and a remote control."""

_SAME_SPREAD, _CLOSE_SPREAD = 0.025, 0.05
"""Shape distances up to which a fit is tried at all: in any colour, and in alike colours."""

_SHAPE_SPOTS = 800
_COLOUR_SPOTS = 4000
_STEPS = 64
COLOUR_BINS = (10, 12, 12)
"""Cells of CIELAB that colours are counted in: L, a, b."""

_LAB_RANGE = ((0, 100), (-60, 60), (-60, 60))


@dataclass(frozen=True, eq=False)
class Fingerprint:
    """What nearness looks at; all but `points` is the same however an object lies.

    Attributes:
        points: Spread over its surface, metres, shape (800, 3).
        distances: Quantiles, ascending, of the distances between these, metres, shape (64,): the
            D2 shape distribution (Osada and others, "Shape Distributions", ACM ToG 21(4), 2002).
        colours: Share of its surface by cells of CIELAB, slightly blurred; sums to 1.
    """

    points: Array
    distances: Array
    colours: Array


@dataclass(frozen=True)
class NearPair:
    """Two near-duplicates and how near they are."""

    one: str
    other: str
    fit: float
    texture: float


def fingerprint(mesh: TexturedMesh) -> Fingerprint:
    """The fingerprint of a mesh; deterministic."""
    points = places(mesh.vertices, mesh.faces, *spots(mesh.vertices, mesh.faces, _SHAPE_SPOTS))
    distances = np.quantile(np.sort(pdist(points)), (np.arange(_STEPS) + 0.5) / _STEPS)
    pixels = colours_at(mesh, *spots(mesh.vertices, mesh.faces, _COLOUR_SPOTS))
    low, high = np.array(_LAB_RANGE, dtype=float).T
    counts = np.histogramdd(np.clip(lab(pixels), low, high), bins=COLOUR_BINS, range=_LAB_RANGE)[0]
    colours = gaussian_filter(counts, 0.7, mode="nearest").reshape(-1)
    return Fingerprint(points, distances, colours / colours.sum())


def shape_distance(one: Fingerprint, other: Fingerprint) -> float:
    """Mean difference of the distributions of distances, by the mean distance; 0 is alike.

    Size counts: a copy 10 % larger is 0.1 away.
    """
    scale = (one.distances.mean() + other.distances.mean()) / 2
    return float(np.abs(one.distances - other.distances).mean() / scale)


def fit_distance(one: Fingerprint, other: Fingerprint) -> float:
    """Mean distance between the surfaces, one laid over the other, by the mean distance."""
    scale = (one.distances.mean() + other.distances.mean()) / 2
    return misfit(one.points, other.points) / float(scale)


def texture_distance(one: Fingerprint, other: Fingerprint) -> float:
    """Share of the surface, 0 to 1, whose colour the other doesn't have."""
    return float(np.abs(one.colours - other.colours).sum() / 2)


def compare(one: Fingerprint, other: Fingerprint) -> tuple[float, float] | None:
    """Fit and texture distance of near-duplicates; None for any other two."""
    spread = shape_distance(one, other)
    if spread > _CLOSE_SPREAD:
        return None
    texture = texture_distance(one, other)
    alike = texture <= CLOSE_TEXTURE
    if spread > _SAME_SPREAD and not alike:
        return None
    fit = fit_distance(one, other)
    return (fit, texture) if fit <= SAME_FIT or (alike and fit <= CLOSE_FIT) else None


def near_pairs(fingerprints: Mapping[str, Fingerprint]) -> list[NearPair]:
    """All near-duplicates among objects, nearest first."""
    ids = sorted(fingerprints)
    shapes = np.array([fingerprints[name].distances for name in ids]).reshape(-1, _STEPS)
    found: list[NearPair] = []
    for number, one in enumerate(ids):
        rest = shapes[number + 1 :]
        scale = (rest.mean(axis=1) + shapes[number].mean()) / 2
        spread = np.abs(rest - shapes[number]).mean(axis=1) / scale
        for place in np.flatnonzero(spread <= _CLOSE_SPREAD):
            other = ids[number + 1 + int(place)]
            near = compare(fingerprints[one], fingerprints[other])
            if near is not None:
                found.append(NearPair(one, other, *near))
    return sorted(found, key=lambda pair: (pair.fit, pair.one, pair.other))
