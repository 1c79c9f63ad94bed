"""The scripts in runs/, as a user starts them."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]


def run_script(name: str, *arguments: str, **settings: str) -> subprocess.CompletedProcess[str]:
    """Run one to its end, with settings in its environment."""
    return subprocess.run(
        [str(ROOT / "runs" / name), *arguments],
        env={**os.environ, "PROBE": f"{sys.executable} -m probe", **settings},
        capture_output=True,
        text=True,
        timeout=1800,
    )
