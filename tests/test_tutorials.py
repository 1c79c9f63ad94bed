"""The tutorials run as they stand, from the first command to the last."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]
TUTORIALS = sorted((ROOT / "docs/tutorials").glob("*.md"))
RUNNABLE = [page for page in TUTORIALS if page.stem in ("add-an-object-set", "write-an-agent")]
"""tests/test_distill.py takes the steps of train-a-student, smaller; the other two pages take long,
and tests of the command line and examples take their steps."""
BLOCK = re.compile(
    r"(?:as `(?P<file>[\w.]+)`:\n\n)?^```(?P<kind>sh|python)\n(?P<code>.*?)^```$", re.M | re.S
)
"""Commands, and code that is run, or saved as a file where the text says so. "no-run" after the
language marks what needs a key, a graphics card or hours."""


def script(page: str) -> str:
    """All that a page tells its reader to do, for bash."""
    lines = ["set -euo pipefail"]
    for number, block in enumerate(BLOCK.finditer(page)):
        if block["kind"] == "sh":
            lines.append(block["code"])
            continue
        file = block["file"] or f"block-{number}.py"
        lines.append(f"cat > {file} <<'CODE'\n{block['code']}CODE")
        if block["file"] is None:
            lines.append(f"python {file}")
    return "\n".join(lines)


def test_every_tutorial_has_commands():
    assert len(TUTORIALS) == 6
    assert all(page.read_text("utf-8").count("\nprobe ") >= 3 for page in TUTORIALS)


def test_a_file_is_saved_and_other_code_is_run():
    page = "Save it as `a.py`:\n\n```python\nx\n```\n\n```python\ny\n```\n\n```sh no-run\nz\n```\n"
    told = script(page)
    assert "cat > a.py" in told and "python a.py" not in told
    assert "python block-1.py" in told and "z" not in told


@pytest.mark.slow
@pytest.mark.parametrize("page", RUNNABLE, ids=lambda page: page.stem)
def test_a_tutorial_runs(page: Path, tmp_path: Path):
    bin_folder = Path(sys.executable).parent
    clean = {k: v for k, v in os.environ.items() if k not in ("PROBE_LIBRARY", "OPENAI_API_KEY")}
    done = subprocess.run(
        ["bash", "-c", script(page.read_text("utf-8"))],
        cwd=tmp_path,
        env={**clean, "PATH": f"{bin_folder}:{os.environ['PATH']}"},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stdout[-2000:] + done.stderr[-2000:]
