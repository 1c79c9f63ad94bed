"""Starting takes little, and imports nothing that the command doesn't need."""

from __future__ import annotations

import resource
import subprocess
import sys

import pytest

from probe.cli import COMMANDS

HEAVY = ("torch", "inspect_ai", "mujoco", "scipy", "fastmcp", "sklearn", "transformers")


def started(code: str) -> tuple[str, float]:
    """What a fresh interpreter prints, and the seconds of CPU that it took."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    assert done.returncode == 0, done.stderr
    spent = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return done.stdout, spent


def loaded(code: str) -> set[str]:
    names = f"print('loaded:', *[name for name in {HEAVY!r} if name in sys.modules])"
    said, _ = started(f"import sys\n{code}\n{names}")
    return set(said.rpartition("loaded:")[2].split())


HELP = """
sys.argv = ["probe", "--help"]
from probe.cli import main
try:
    main()
except SystemExit:
    pass
"""


def test_the_list_of_commands_imports_none_of_them():
    assert loaded(HELP) == set()
    said, _ = started("import sys" + HELP)
    assert all(name in said for name in COMMANDS)


def test_the_package_imports_nothing():
    assert loaded("import probe") == set()


def test_a_run_without_a_model_needs_no_harness():
    assert loaded("import probe.cli.run") & {"torch", "inspect_ai"} == set()


@pytest.mark.slow
def test_starting_takes_little():
    """Seconds of CPU, the best of three: other processes may slow one down."""
    assert min(started("import sys" + HELP)[1] for _ in range(3)) < 0.4
    assert min(started("import probe")[1] for _ in range(3)) < 0.6
