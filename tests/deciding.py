"""What decides how each built-in object comes out, and whether all passed as it is now.

To build and check them all takes many minutes. Tests that do are marked ``every_object``; they run
wherever something that decides the objects has changed since ``make every-object`` last passed,
and a share of the objects is checked by other tests each time.
"""

from __future__ import annotations

import hashlib
import re
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
PASSED = Path(__file__).with_name("every_object.sha256")
SOURCES = (
    *("src/probe/types.py", "src/probe/assets/looks.py", "src/probe/assets/colour/names.py"),
    *("src/probe/assets/procedural", "src/probe/assets/mesh", "src/probe/assets/tabletops"),
    *("src/probe/assets/collision", "src/probe/assets/pools", "src/probe/assets/data"),
    *("scripts/divide_objects.py", "tests/every_object.py", "tests/assets/procedural"),
    "tests/assets/pools/test_pools_apart.py",
)
PACKAGES = ("numpy", "scipy", "pillow", "trimesh")


def state() -> str:
    """A hash of all that decides, the versions of packages included."""
    found = hashlib.sha256()
    for file in _files():
        found.update(f"{file.relative_to(ROOT)} {len(file.read_bytes())} ".encode())
        found.update(file.read_bytes())
    pinned = re.findall(r"^([\w-]+)==(\S+)", (ROOT / "requirements.lock").read_text(), re.M)
    found.update(repr([pin for pin in pinned if pin[0] in PACKAGES]).encode())
    return found.hexdigest()


def all_passed() -> bool:
    """Whether nothing that decides has changed since all objects passed."""
    return PASSED.is_file() and PASSED.read_text().strip() == state()


def _files() -> list[Path]:
    found: list[Path] = []
    for source in SOURCES:
        path = ROOT / source
        inside = path.rglob("*") if path.is_dir() else (path,)
        found += [it for it in inside if it.is_file() and "__pycache__" not in it.parts]
    return sorted(found)


if __name__ == "__main__":
    print(state())
