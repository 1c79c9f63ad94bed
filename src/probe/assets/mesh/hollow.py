"""Whether an object is a vessel. Geometry alone."""

from __future__ import annotations

import numpy as np

from probe.assets.collision.cavity import find_cavity
from probe.assets.collision.hulls import hull_volume
from probe.assets.mesh.mesh import TexturedMesh

SHARE = 0.45
"""Of the hull that a cavity open up or down has to fill. On the 132 scans fit for use it finds 22
of 26 that were judged hollow by eye (not a teapot, its lid, a hat and a bell, whose cavities are
a smaller share) and one of the other 106, an open box."""


def is_hollow(mesh: TexturedMesh) -> bool:
    """Whether it has a cavity, open upwards or downwards, that could hold or cover something."""
    vertices = mesh.vertices.astype(np.float64)
    cavity = find_cavity(vertices, mesh.faces)
    if cavity is None or abs(cavity.mouth_from_object[2, 2]) < 0.5:
        return False
    return cavity.volume > SHARE * hull_volume(vertices)
