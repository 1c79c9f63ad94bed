"""Ways in for other people's objects, one file a format."""

from __future__ import annotations

from probe.assets.importers.bop import BOP
from probe.assets.importers.gltf import GLTF
from probe.assets.importers.gso import GSO
from probe.assets.importers.obj import OBJ
from probe.assets.importers.source import Format, Importer

IMPORTERS: dict[Format, Importer] = {"gltf": GLTF, "obj": OBJ, "gso": GSO, "bop": BOP}
