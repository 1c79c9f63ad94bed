"""Table tops drawn by formula, all seamless. Knows no renderer and no files."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial

import numpy as np

from probe.assets.tabletops import cloth, stone, wood
from probe.assets.tabletops.sheet import Sheet

PAINTERS: Mapping[str, Callable[[np.random.Generator], Sheet]] = {
    "oak_planks": partial(wood.planks, wood.OAK),
    "walnut": partial(wood.planks, wood.WALNUT),
    "bamboo": partial(wood.planks, wood.BAMBOO),
    "beech": partial(wood.planks, wood.BEECH),
    "white_laminate": cloth.laminate,
    "grey_granite": stone.granite,
    "white_marble": stone.marble,
    "slate": stone.slate,
    "terrazzo": stone.terrazzo,
    "cork": stone.cork,
    "linen": cloth.linen,
    "red_gingham": cloth.gingham,
    "green_felt": cloth.felt,
}

__all__ = ["PAINTERS", "Sheet"]
