"""Ways in for other people's objects, one file a format."""

from __future__ import annotations

from probe.assets.importers.bop import BOP
from probe.assets.importers.gltf import GLTF
from probe.assets.importers.gso import GSO
from probe.assets.importers.source import Format, Importer
from probe.assets.importers.wavefront import OBJ

IMPORTERS: dict[Format, Importer] = {"gltf": GLTF, "obj": OBJ, "gso": GSO, "bop": BOP}
