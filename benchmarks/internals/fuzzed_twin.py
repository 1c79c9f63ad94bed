"""What a twin's physics does while its bridge is sent thousands of commands, most of them wrong.

`python benchmarks/internals/fuzzed_twin.py`. Measures internals, not the public API; the test
beside tests/twin does the same with fewer commands. About 7 minutes for 2,000.
"""

from __future__ import annotations

import sys
from pathlib import Path

import tyro

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tests"), str(ROOT / "bridge/tests")]

from twin.test_fuzzed_twin import fuzzed  # noqa: E402


def main(commands: int = 2000, seed: int = 20) -> None:
    """Print by how much each kind of limit was passed; what is negative was kept.

    Args:
        commands: How many are sent.
        seed: Of the commands.
    """
    found = fuzzed(commands, seed)
    print(f"{commands} commands, {found['moving']:.0f} steps of 2 ms in motion")
    print(f"joint ranges passed by {found['range']:.3f} rad, the box by {found['box']:.3f} m")
    print(f"largest share of a joint's speed limit: {found['speed']:.3f}")


if __name__ == "__main__":
    tyro.cli(main)
