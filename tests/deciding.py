"""What decides how each built-in object comes out, and whether all passed as it is now.

To build and check them all takes many minutes. Tests that do are marked ``every_object``; they run
wherever something that decides the objects has changed since ``make every-object`` last passed,
and a share of the objects is checked by other tests each time.
"""

from __future__ import annotations

import hashlib
import re
from collections.abc import Iterable
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
PASSED = Path(__file__).with_name("every_object.sha256")
ASSETS = ROOT / "src/probe/assets"
TASKS = ROOT / "src/probe/tasks"
SOURCES = (
    *(ROOT / "src/probe/__init__.py", ROOT / "src/probe/types.py"),
    *(ASSETS / "looks.py", ASSETS / "spec.py", ASSETS / "tables.py", ASSETS / "colour/names.py"),
    *(ASSETS / "library.py", ASSETS / "cache.py", ASSETS / "recent.py", ASSETS / "recipes.py"),
    *(ASSETS / "procedural", ASSETS / "mesh", ASSETS / "tabletops"),
    *(ASSETS / "collision", ASSETS / "pools", ASSETS / "data"),
    *(TASKS / "suite.py", TASKS / "suite_file.py"),
    *(TASKS / "data/v1.json", TASKS / "data/v1-unfiltered.json"),
    *(ROOT / "scripts/divide_objects.py", ROOT / "tests/every_object.py"),
    *(ROOT / "tests/assets/procedural", ROOT / "tests/assets/pools"),
    ROOT / "tests/assets/test_tables.py",
    ROOT / "tests/verification/test_packaged.py",
)
PACKAGES = (
    *("numpy", "scipy", "pillow", "trimesh", "embreex"),
    *("pyyaml", "pydantic", "pydantic-core"),
)


def state(sources: Iterable[Path] = SOURCES) -> str:
    """A hash of files, those in folders included, and of the versions of packages."""
    found = hashlib.sha256()
    for file in _files(sources):
        found.update(f"{file.relative_to(ROOT)} {len(file.read_bytes())} ".encode())
        found.update(file.read_bytes())
    pinned = re.findall(r"^([\w-]+)==(\S+)", (ROOT / "requirements.lock").read_text(), re.M)
    found.update(repr([pin for pin in pinned if pin[0] in PACKAGES]).encode())
    return found.hexdigest()


def all_passed() -> bool:
    """Whether nothing that decides has changed since all objects passed."""
    return PASSED.is_file() and PASSED.read_text().strip() == state()


def _files(sources: Iterable[Path]) -> list[Path]:
    found: list[Path] = []
    for source in sources:
        assert source.exists(), f"{source} has gone: say in {__file__} what decides instead"
        inside = source.rglob("*") if source.is_dir() else (source,)
        found += [it for it in inside if it.is_file() and "__pycache__" not in it.parts]
    return sorted(found)


if __name__ == "__main__":
    print(state())
