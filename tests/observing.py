"""What a process makes of a seed, for tests that compare processes."""

from __future__ import annotations

import hashlib
from pathlib import Path

from probe.assets.library import open_library
from probe.assets.tables import load_table, table_ids
from probe.render.photograph import load_scene, photograph
from probe.render.renderer import Renderer
from probe.world.scenes import make_scene


def digest(seed: int, assets: Path, cache: Path) -> str:
    """Of a settled scene of scans, its picture, depth and labels, made by this process."""
    things = open_library("scans", assets, cache)
    scene = make_scene(seed, things, table_ids(assets))
    with Renderer() as own:
        load_scene(own, scene, things, load_table(scene.table, assets))
        frame = photograph(own, scene)
    assert frame.rgb is not None and frame.labels is not None
    pixels = (frame.rgb.tobytes(), frame.depth.tobytes(), frame.labels.tobytes())
    return hashlib.sha256(b"".join((repr(scene).encode(), *pixels))).hexdigest()
