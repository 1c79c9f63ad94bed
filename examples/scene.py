"""From a seed to a picture: `python examples/scene.py --help`."""

from __future__ import annotations

from pathlib import Path

import tyro
from PIL import Image

import probe


def main(seed: int = 7, objects: int = 15, out: Path = Path("outputs/examples/scene.png")) -> None:
    """Settle a table, photograph it from above, and print how much of each object is visible.

    Args:
        seed: Any whole number from 0; the same seed gives the same bytes.
        objects: How many; fewer settle faster.
        out: File for the picture.
    """
    library = probe.open_library("procedural")
    scene = probe.make_scene(seed, library, objects=objects)
    # One renderer for both: starting one takes a second.
    with probe.Renderer() as renderer:
        frame = probe.photograph(scene, library, renderer=renderer)
        visible = probe.visibility(scene, library, renderer=renderer)
    assert frame.rgb is not None
    out.parent.mkdir(parents=True, exist_ok=True)
    Image.fromarray(frame.rgb).save(out)
    # This is the truth of a simulated table; no tool tells it to an agent.
    for placed in sorted(scene.objects, key=lambda placed: visible[placed.instance].fraction):
        share = visible[placed.instance].fraction
        print(f"{share:4.0%} of the {library[placed.object_id].name} is visible")
    print(f"The picture is {out}")


if __name__ == "__main__":
    tyro.cli(main)
