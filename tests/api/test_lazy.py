"""`import probe` is quick and brings nothing heavy."""

from __future__ import annotations

import subprocess
import sys

CODE = """
import sys, time
start = time.process_time()
import probe
took = time.process_time() - start
heavy = {"numpy", "mujoco", "pydantic", "inspect_ai", "torch", "ray"} & set(sys.modules)
assert not heavy, heavy
assert "play" in dir(probe)
print(took)
"""


def test_nothing_heavy_is_imported():
    ended = subprocess.run([sys.executable, "-c", CODE], capture_output=True, text=True, check=True)
    # CPU time, so that a busy machine is no failure; wall time on an idle one is about 10 ms.
    assert float(ended.stdout) < 0.1


def test_unknown_names_are_refused():
    code = "import probe; probe.plya"
    ended = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    assert "module 'probe' has no attribute 'plya'" in ended.stderr
