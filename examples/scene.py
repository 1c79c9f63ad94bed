"""From a seed to a picture: `python examples/scene.py --help`."""

from __future__ import annotations

from pathlib import Path

import tyro

from probe.assets.tables import load_table, table_ids
from probe.cli.resources import library
from probe.files import write_picture
from probe.render.photograph import load_scene, measure, photograph
from probe.render.renderer import Renderer
from probe.world.scenes import make_scene


def main(seed: int = 7, objects: int = 15, out: Path = Path("outputs/examples/scene.png")) -> None:
    """Settle a table, draw it from above and say what can't be seen.

    Args:
        seed: Any whole number; the same seed gives the same bytes.
        objects: How many; fewer settle faster.
        out: File for the picture.
    """
    things = library("procedural")
    # None stands for "no folder of extra assets": only tables that are drawn by formula.
    settled = make_scene(seed, things, table_ids(None), objects)
    with Renderer() as renderer:
        load_scene(renderer, settled, things, load_table(settled.table, None))
        frame = photograph(renderer, settled)
        shares = measure(renderer, settled)
    assert frame.rgb is not None
    write_picture(out, frame.rgb)
    # Labels and shares are the truth of a simulated table; no tool hands them to an agent.
    for placed in sorted(settled.objects, key=lambda placed: shares[placed.instance].fraction):
        print(f"{shares[placed.instance].fraction:4.0%} of {things[placed.object_id].name} shows")
    print(f"The picture is {out}")


if __name__ == "__main__":
    tyro.cli(main)
