"""How large things are, for Size. Geometry of single objects."""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from scipy.spatial import ConvexHull

from probe.assets.library import Library
from probe.tasks.truth import Extent


@lru_cache(maxsize=2048)
def extent_of(library: Library, object_id: str) -> Extent:
    """Longest side and footprint of its box in the resting pose, and volume of its hull."""
    x, y, _ = size = library[object_id].size
    vertices = np.asarray(library.form(object_id).mesh.vertices, float)
    return Extent(max(size), x * y, float(ConvexHull(vertices).volume))
