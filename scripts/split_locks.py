"""Remove from a folder's lock files what others have, and split torch from what GPUs need.

A helper of scripts/lock; needs nothing but Python.
"""

from __future__ import annotations

import re
import sys
from pathlib import Path

# What PyPI's builds of torch want, and builds for CPUs alone don't; and these builds themselves.
_CARDS = re.compile(r"(cuda|nvidia|triton|torch==)")


def entries(path: Path) -> tuple[str, dict[str, str]]:
    """A lock file's first comments, and by the first words of each entry the whole of it."""
    head, *rest = re.split(r"^(?=[a-z0-9])", path.read_text("utf-8"), flags=re.MULTILINE)
    return head, {entry.split(" \\")[0]: entry for entry in rest}


def write(path: Path, head: str, kept: dict[str, str]) -> None:
    path.write_text(head + "".join(kept.values()), "utf-8")


def main(folder: Path) -> None:
    """Turn the lock files that uv wrote into a folder into those of this repository."""
    _, always = entries(folder / "requirements.lock")
    for name in ("docs", "mutants", "ray", "rerun", "train"):
        path = folder / f"requirements-{name}.lock"
        head, found = entries(path)
        write(path, head, {key: it for key, it in found.items() if key not in always})
    train = folder / "requirements-train.lock"
    head, found = entries(train)
    cards = {key: it for key, it in found.items() if _CARDS.match(key)}
    others = {key: it for key, it in found.items() if key not in cards}
    write(folder / "requirements-cuda.lock", head, cards)
    write(folder / "requirements-torch.lock", head, others)
    train.unlink()


if __name__ == "__main__":
    main(Path(sys.argv[1]))
