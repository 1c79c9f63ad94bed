"""Files that other files name: found inside one folder, or refused."""

from __future__ import annotations

from pathlib import Path

from probe.errors import BadMesh

MAX_BYTES = 2**30


class MissingFile(BadMesh):
    """A file names one that isn't there, or none where it should; the reason alone is kept."""

    def __init__(self, path: object, reason: str, remedy: str) -> None:
        super().__init__(path, reason, remedy)
        self.reason = reason


def confined(path: Path, name: str, *folders: Path, root: Path | None = None) -> Path:
    """The file that `path` calls by a name relative to one of some folders, the first that has it.

    Args:
        path: Who names it; for messages.
        name: As it stands in the file.
        folders: Where to look, in order.
        root: What must not be left, links followed; the first of the folders by default.

    Raises:
        MissingFile: The name leads to nothing.
        BadMesh: It leads outside, or to something too large.
    """
    home = (root or folders[0]).resolve()
    if not name or "://" in name or "\x00" in name or _absolute(name):
        raise _outside(path, name)
    try:
        candidates = [folder / name.replace("\\", "/") for folder in folders]
        there = [found for found in candidates if found.is_file()]
        chosen = (there or candidates)[0]
        if not chosen.resolve().is_relative_to(home):
            raise _outside(path, name)
        if there and chosen.stat().st_size > MAX_BYTES:
            raise BadMesh(path, f"refers to {name[:80]!r}, which is too large", "Reduce it.")
    except (OSError, RuntimeError, ValueError) as error:
        raise BadMesh(path, f"refers to {name[:80]!r} ({error})", "Correct the path.") from error
    if not there:
        reason = f"refers to {name[:80]!r}, which isn't there"
        raise MissingFile(path, reason, "Copy it along, or correct the name.")
    return chosen


def _absolute(name: str) -> bool:
    return name.startswith(("/", "\\")) or name[1:2] == ":"


def _outside(path: Path, name: str) -> BadMesh:
    remedy = "Copy what it needs into its folder and correct the path."
    return BadMesh(path, f"refers to {name[:80]!r} outside its own folder", remedy)
