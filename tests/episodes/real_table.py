"""A recorded episode on a simulated table; as a script it replays a file and prints the bytes."""

from __future__ import annotations

import sys
from pathlib import Path

TESTS = Path(__file__).resolve().parents[1]
if __name__ == "__main__":
    sys.path.insert(0, str(TESTS))

from boxes import box_library, standing, station_at  # noqa: E402
from probe import manipulation  # noqa: E402
from probe.episodes.files import line_of, read_records  # noqa: E402
from probe.episodes.replay import replay  # noqa: E402
from probe.perception.oracle import Oracle  # noqa: E402
from probe.render.renderer import Renderer  # noqa: E402
from probe.scene.setup import UR5_TABLE  # noqa: E402
from probe.toolshed.toolshed import Toolshed  # noqa: E402

LIBRARY = box_library(
    red_lid=(0.14, 0.11, 0.03, 190, 40, 40),
    blue_block=(0.06, 0.05, 0.04, 40, 80, 180),
    white_cube=(0.03, 0.03, 0.03, 235, 235, 235),
)
SCENE = standing(
    LIBRARY,
    ("red_lid", 0.05, 0.05, 0.03),
    ("blue_block", -0.14, 0.12, 0.0),
    ("white_cube", 0.03, 0.05, 0.0),
    ("white_cube", 0.08, 0.06, 0.0),
)


def fresh(renderer: Renderer):
    """A fresh table with two white cubes under a lid, and its tools."""
    station = station_at(SCENE, LIBRARY, renderer)
    specs = {o.instance: LIBRARY[o.object_id] for o in SCENE.objects}
    tools = Toolshed(station, Oracle(specs), manipulation, UR5_TABLE, pictures=False)
    return station, tools


def main(path: Path) -> None:
    """Replay the first record of a file and print it without timing."""
    (record,) = read_records(path)
    with Renderer() as renderer:
        station, tools = fresh(renderer)
        sys.stdout.buffer.write(line_of(replay(record, tools, station), timed=False))


if __name__ == "__main__":
    main(Path(sys.argv[1]))
