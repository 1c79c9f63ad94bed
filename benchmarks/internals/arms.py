"""How often the tools work with a set-up's arm: `python benchmarks/internals/arms.py`.

Measures internals, not the public API.

How many poses of the hand over the work area are in reach, what finding that out costs, and the
trials of `probe tools bench`, with true masks and without noise, on tables of other set-ups.
"""

from __future__ import annotations

import itertools
import time
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import get_args

import numpy as np
import tyro
from scipy.spatial.transform import Rotation

import probe
from probe.episodes.noise import NOISES
from probe.errors import Unsatisfiable
from probe.station.arms import arm_of, hand_of
from probe.tool_bench.attempt import attempt
from probe.tool_bench.table import lay
from probe.tool_bench.trial import Tool, ToolTrial
from probe.types import Pose

SETUPS = Path(__file__).parents[2] / "examples" / "setups"


def reach(setup: probe.Setup, count: int) -> tuple[float, float]:
    """Share of random poses of the hand that the arm reaches, and milliseconds that each took.

    The pads are over the work area, 2 to 25 cm high; the hand leans up to 60 degrees.
    """
    arm, length = arm_of(setup.mount), hand_of(setup).pad_reach(setup.gripper.max_opening / 2)
    rng, half = np.random.default_rng(0), setup.work_area / 2
    poses: list[Pose] = []
    for _ in range(count):
        heading, turn = rng.uniform(0, 2 * np.pi, 2)
        lean = rng.uniform(0, np.pi / 3)
        rotation = Rotation.from_euler("ZYZ", [heading, np.pi - lean, turn])
        place = rng.uniform((-half, -half, 0.02), (half, half, 0.25))
        place = place - length * rotation.as_matrix()[:, 2]
        poses.append(Pose.of(place, rotation.as_quat(scalar_first=True)))
    start = time.process_time()
    found = [bool(arm.inverse(pose)) for pose in poses]
    return float(np.mean(found)), 1000 * (time.process_time() - start) / count


def trials(
    tool: Tool, setup: probe.Setup, things: probe.Library, renderer: probe.Renderer, first: int
) -> Iterator[ToolTrial]:
    """Trials without end, table by table."""
    for seed in itertools.count(first):
        try:
            laid = lay(seed, tool, things, renderer, setup)
        except Unsatisfiable:
            continue
        for target in laid.targets:
            yield attempt(tool, laid, target, things, renderer, NOISES["none"])


def main(
    setup: Path = SETUPS / "jaco.json",
    poses: int = 2000,
    grasps: int = 40,
    pushes: int = 20,
    first_seed: int = 40_000,
) -> None:
    """Print what is in reach, how many attempts succeeded, and what became of the others.

    Args:
        setup: File.
        poses: Of the hand.
        grasps: Attempts.
        pushes: Attempts.
        first_seed: Of the first table.
    """
    table, things = probe.read_setup(setup), probe.open_library()
    share, cost = reach(table, poses)
    print(f"{table.name}: reaches {share:.1%} of {poses} poses, {cost:.2f} ms each", flush=True)
    with probe.Renderer() as renderer:
        for tool, wanted in zip(get_args(Tool), (grasps, pushes), strict=True):
            found = trials(tool, table, things, renderer, first_seed)
            tried: list[ToolTrial] = []
            for trial in itertools.islice(found, wanted):
                print(f"  {trial.object_id} (seed {trial.seed}): {trial.cause}", flush=True)
                tried.append(trial)
            good = sum(trial.good for trial in tried)
            causes = Counter(trial.cause for trial in tried)
            print(f"{table.name}: {tool} succeeds in {good} of {wanted} trials", flush=True)
            print("  " + ", ".join(f"{cause} {n}" for cause, n in causes.most_common()), flush=True)


if __name__ == "__main__":
    tyro.cli(main)
