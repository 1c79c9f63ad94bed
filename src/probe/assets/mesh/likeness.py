"""Near-duplicates whatever their size: one shape in much the same colours. Knows no pools.

`nearness.py` tells apart what has another size, and joins what differs in colour alone: so a scan
is told from its copy. Objects made by formula come in series of one shape, and a series must not
count as one object; but an object enlarged, or a shade lighter, is the same to the eye.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass

import numpy as np
from scipy.ndimage import gaussian_filter

from probe.assets.mesh.nearness import (
    CLOSE_TEXTURE,
    COLOUR_BINS,
    SAME_FIT,
    Fingerprint,
    NearPair,
    fit_distance,
)
from probe.types import Array

_SHADES = 2.6
"""By how many cells of CIELAB, 10 units each, colours are blurred before they are compared. Two
plain colours then count as alike (CLOSE_TEXTURE) up to 20 units apart: white and cream, red and
crimson, but not red and dark red, 25 apart."""

_SAME_SPREAD, _SAME_AXES, _SAME_REACH = 0.02, 0.045, 0.03
"""Differences up to which a fit is tried: of distances between points, of the points' standard
deviations along the principal axes, of their distances from the middle; by the mean distance
between points. Of 1,120 pairs that these limits find among 2,877 objects, 99 in 100 lie within
0.018, 0.039 and 0.029; of 40 pairs each with spreads of 0.02 to 0.05, none fits."""


@dataclass(frozen=True, eq=False)
class _Plain:
    """An object as it is with a mean distance of 1 between its points, shades blurred."""

    seen: Fingerprint
    axes: Array
    reach: Array

    @property
    def shape(self) -> bytes:
        """The same for objects of one shape, whatever their size and colours."""
        return np.round(self.seen.points[:8], 3).tobytes()


def like_pairs(prints: Mapping[str, Fingerprint]) -> list[NearPair]:
    """All near-duplicates among objects whatever their size, nearest first.

    Two are near-duplicates if they fit as well as two samples of one shape do (SAME_FIT) and at
    most CLOSE_TEXTURE of the surface of one has a colour that the other doesn't have.
    """
    ids = sorted(prints)
    plain = [_plain(prints[name]) for name in ids]
    found: list[NearPair] = []
    fits: dict[tuple[bytes, bytes], float] = {}  # series share them
    for one, other, texture in _worth_a_fit(plain):
        shapes = plain[one].shape, plain[other].shape
        if shapes not in fits:
            fits[shapes] = fit_distance(plain[one].seen, plain[other].seen)
        fit = fits[shapes]
        if fit <= SAME_FIT:
            found.append(NearPair(ids[one], ids[other], fit, texture))
    return sorted(found, key=lambda pair: (pair.fit, pair.one, pair.other))


def _plain(seen: Fingerprint) -> _Plain:
    size = float(seen.distances.mean())
    points = seen.points / size
    away = points - points.mean(axis=0)
    reach = np.sort(np.linalg.norm(away, axis=1))
    axes = np.sqrt(np.maximum(np.linalg.eigvalsh(np.cov(away.T)), 0))
    colours = gaussian_filter(seen.colours.reshape(COLOUR_BINS), _SHADES, mode="nearest")
    colours = (colours / colours.sum()).reshape(-1)
    return _Plain(Fingerprint(points, seen.distances / size, colours), axes, reach)


def _worth_a_fit(plain: list[_Plain]) -> Iterator[tuple[int, int, float]]:
    """Pairs that may fit, with their texture distance; a fit takes a thousand times as long."""
    if not plain:
        return
    spreads = np.array([it.seen.distances for it in plain])
    axes = np.array([it.axes for it in plain])
    reaches = np.array([it.reach for it in plain])
    colours = np.array([it.seen.colours for it in plain], dtype=np.float32)
    for one in range(len(plain) - 1):
        rest = np.arange(one + 1, len(plain))
        rest = rest[np.abs(axes[rest] - axes[one]).max(axis=1) <= _SAME_AXES]
        rest = rest[np.abs(spreads[rest] - spreads[one]).mean(axis=1) <= _SAME_SPREAD]
        rest = rest[np.abs(reaches[rest] - reaches[one]).mean(axis=1) <= _SAME_REACH]
        textures = np.abs(colours[rest] - colours[one]).sum(axis=1) / 2
        for other, texture in zip(rest, textures, strict=True):
            if texture <= CLOSE_TEXTURE:
                yield one, int(other), float(texture)
