"""What all tests share: where the extra assets and the cache lie."""

from __future__ import annotations

import os
from collections.abc import Generator
from pathlib import Path

import pytest
from hypothesis import settings

# Before any test imports NumPy: what they compute and keep must be what `probe` computes.
import probe
from deciding import all_passed

# The same examples in every run: what a change is judged by mustn't depend on luck.
# No deadline: a slow disk or a busy machine is no defect.
settings.register_profile("same", derandomize=True, database=None, deadline=None)
settings.load_profile("same")

assert probe.SUMS_BOUND, (
    "NumPy was imported before probe, or the environment binds sums otherwise: they differ here"
)

ROOT = Path(__file__).resolve().parents[1]

LONGEST = (
    "test_golden.py",
    "test_packaged.py",
    "test_pools_apart.py",
    "test_on_ray.py",
    "test_ray.py",
    "test_distill.py",
    "test_student.py",
    "test_tutorials.py",
    "test_attacks.py",
    "test_compare.py",
)
"""Files whose tests take minutes, the longest first."""


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Begin with the files that take longest, so that no worker is left with them at the end.

    What goes through every built-in object is left out while that is known to pass.
    """
    items.sort(key=lambda item: (*LONGEST, item.path.name).index(item.path.name))
    left_out = {item for item in items if item.get_closest_marker("every_object")}
    if left_out and "every_object" not in config.option.markexpr and all_passed():
        config.hook.pytest_deselected(items=list(left_out))
        items[:] = [item for item in items if item not in left_out]


@pytest.fixture(scope="session", autouse=True)
def own_data(tmp_path_factory: pytest.TempPathFactory) -> Generator[Path]:
    """The user's own data: none. Tests make keys there, and nobody's objects take part in them."""
    folder = tmp_path_factory.mktemp("data-home")
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("XDG_DATA_HOME", str(folder))
        yield folder / "probe"


@pytest.fixture(scope="session", autouse=True)
def shared_cache(cache: Path) -> Generator[None]:
    """What any test or any command computes, no other computes again."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("XDG_CACHE_HOME", str(cache.parent))
        yield


@pytest.fixture(scope="session")
def assets() -> Path:
    """The folder of extra assets (scans, textures, robots), which no checkout contains."""
    folder = os.environ.get("PROBE_ASSETS")
    if not folder:
        pytest.skip("PROBE_ASSETS names no folder of extra assets")
    path = Path(folder).resolve()
    if not path.is_dir():
        pytest.fail(f"PROBE_ASSETS={folder} is not a folder")
    return path


@pytest.fixture(scope="session")
def cache() -> Path:
    """Where costly results, named by content, are kept over runs; workers may share it."""
    path = ROOT / ".cache" / "probe"
    path.mkdir(parents=True, exist_ok=True)
    return path
