"""Plants 12 faults in a twin's process, and prints what `probe robot check` names.

Each check runs in a process of its own, as on another computer. What the kit recovers of the
errors of healthy cameras is printed beside their truth, which only this file knows.

`python benchmarks/internals/kit_faults.py --help`. Measures internals, not the public API.
"""

from __future__ import annotations

import json
import multiprocessing
import sys
import tempfile
import time
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

ROOT = Path(__file__).parents[2]
sys.path[:0] = [str(ROOT / "bridge" / "tests")]

from faults import PLANTS, plant  # noqa: E402

from probe.api.resources import cache_folder  # noqa: E402
from probe.cli.screen import ScreenTable, say  # noqa: E402
from probe.render.renderer import Renderer  # noqa: E402
from probe.robot_check.box import KnownBox  # noqa: E402
from probe.robot_check.checking import Wishes, check, kit_of  # noqa: E402
from probe.robot_check.fitting import apart  # noqa: E402
from probe.scene.setup import UR5_TABLE, Setup  # noqa: E402
from probe.scene.setup_file import read_setup  # noqa: E402
from probe.twin.flaws import Flaws  # noqa: E402
from probe.twin.only_box import BoxLibrary, box_scene  # noqa: E402
from probe.twin.serving import TwinSettings, listening, twin_of  # noqa: E402
from probe.types import Pose  # noqa: E402

TOKEN = "a token for nobody else"
_PX = 512
_JACO = ROOT / "examples" / "setups" / "jaco.json"
FAULTS = ["", "bad token", *PLANTS]
SETUPS = {"ur5": (UR5_TABLE, 1.0), "jaco": (read_setup(_JACO), 2.0)}


def main(seeds: int = 2) -> None:
    """Check each fault with several seeds, on both arms in turn."""
    table = ScreenTable("fault", "arm", "seed", "named", "after s", "how")
    for seed in range(1, seeds + 1):
        arm = ("ur5", "jaco")[seed % 2]
        setup, haste = SETUPS[arm]
        for fault in FAULTS:
            began = time.monotonic()
            rows, cameras = _checked(replace(setup, picture_px=_PX), haste, fault, seed)
            bad = [row for row in rows if row["verdict"] == "failed"]
            named = ", ".join(dict.fromkeys(row["fault"] for row in bad)) or "nothing"
            how = bad[0]["text"] if bad else _recovered(rows, cameras)
            seconds = f"{time.monotonic() - began:.0f}"
            say(f"{fault or 'none'} | {arm} | {seed} | {named} | {seconds} | {how}")
            table.add(fault or "none", arm, str(seed), named, seconds, how)
    table.show(160)


def _checked(
    setup: Setup, haste: float, fault: str, seed: int
) -> tuple[list[dict[str, Any]], dict[str, tuple[Pose, Pose]]]:
    """Rows of the kit's outcomes, and each camera's told and true pose."""
    box, settings = KnownBox(), TwinSettings(Flaws(), haste, seed, ("front",))
    with (
        tempfile.TemporaryDirectory() as folder,
        Renderer(cache_folder() / "light") as renderer,
        twin_of(
            box_scene(setup, seed), BoxLibrary(box.size, cache_folder()), renderer, settings
        ) as robot,
        listening(robot, TOKEN, "127.0.0.1", 0) as address,
    ):
        driver: Any = robot._driver  # pyright: ignore[reportPrivateUsage]
        true = {name: camera.world_from_camera for name, camera in driver._cameras.items()}
        token = TOKEN
        if fault in PLANTS:
            plant(robot, fault, seed)
        elif fault:
            token = f"not the token {seed}"
        found, cameras = Path(folder) / "found.json", Path(folder) / "cameras.json"
        process = multiprocessing.get_context("spawn").Process(
            target=look, args=(address, token, setup, found, cameras)
        )
        process.start()
        process.join()
        poses: dict[str, tuple[Pose, Pose]] = {}
        if cameras.exists():
            for row in json.loads(cameras.read_text()):
                corrected = Pose(tuple(row["position"]), tuple(row["wxyz"]))
                poses[row["name"]] = corrected, true[row["name"]]
        return json.loads(found.read_text()), poses


def look(address: str, token: str, setup: Setup, found: Path, cameras: Path) -> None:
    """Check a robot, as a person would who lets everything happen."""
    kit = kit_of(address, token, None, lambda outcome: None)
    check(kit, Wishes(setup, KnownBox(), corrected=cameras), lambda text: True)
    found.write_text(json.dumps([outcome.values() for outcome in kit.outcomes]))


def _recovered(rows: list[dict[str, Any]], cameras: dict[str, tuple[Pose, Pose]]) -> str:
    """What is left of the front camera's error once it is corrected, and what there was."""
    corrected, true = cameras["front"]
    left = apart(corrected, true)
    row = next(row for row in rows if row["check"] == "camera front")
    told = {measure["name"]: measure["value"] for measure in row["measures"]}
    return (
        f"things off by {told['things seem off by']:.1f} mm, {told['once corrected']:.1f} mm once"
        f" corrected; of the pose's 2 mm and 0.5 degrees {1000 * left[0]:.1f} mm and"
        f" {np.degrees(left[1]):.2f} degrees are left"
    )


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
