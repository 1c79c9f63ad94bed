"""Which files an agent's process may read: what Python needs, never a suite. Opens none."""

from __future__ import annotations

import contextlib
import sys
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

import probe

PACKAGE = Path(probe.__file__).resolve().parent
_DATA = Path("tasks") / "data"
ANSWERS = PACKAGE / _DATA
"""Where the packaged suites lie, with their answers."""

_SYSTEM = (
    "/usr", "/bin", "/lib", "/lib64", "/etc/alternatives", "/etc/fonts", "/etc/hosts",
    "/etc/ld.so.cache", "/etc/localtime", "/etc/nsswitch.conf", "/etc/resolv.conf", "/etc/ssl",
    "/proc/cpuinfo", "/proc/meminfo", "/proc/stat", "/sys/devices/system/cpu",
)  # fmt: skip


@dataclass(frozen=True)
class Reach:
    """What may be read.

    Attributes:
        whole: Files and folders with all that is in them.
        names: Folders of which the names in them may be seen.
    """

    whole: tuple[str, ...]
    names: tuple[str, ...]


def reach(file: Path, own: Iterable[Path], hidden: Iterable[Path]) -> Reach:
    """What an agent's process may read.

    Args:
        file: The agent's own, wherever it lies.
        own: What was allowed beside it.
        hidden: What must not be read, even within that: the suite, the folder of records.
    """
    prefixes = {sys.prefix, sys.base_prefix, sys.exec_prefix, sys.base_exec_prefix}
    copies = [each for one in prefixes for each in Path(one).glob("lib/python*/*-packages/probe")]
    shut = {ANSWERS, *(path.resolve() for path in (*hidden, *(it / _DATA for it in copies)))}
    whole, names = {str(file.resolve()): None}, dict[str, None]()
    for start in (*map(Path, _SYSTEM), *map(Path, sorted(prefixes)), PACKAGE, *own):
        if start.exists():
            _gather(start.resolve(), shut, whole, names)
    # Python looks for modules by listing folders.
    names[str(PACKAGE.parent)] = None
    return Reach(tuple(whole), tuple(names))


def _gather(path: Path, shut: set[Path], whole: dict[str, None], names: dict[str, None]) -> None:
    """Add a path; of a folder that holds something hidden, each of the others in it."""
    if any(path == each or each in path.parents for each in shut):
        return
    if not any(path in each.parents for each in shut):
        whole[str(path)] = None
        return
    names[str(path)] = None
    # What we may not list, the agent may not either.
    with contextlib.suppress(PermissionError):
        for entry in sorted(path.iterdir()):
            if not entry.is_symlink():
                _gather(entry, shut, whole, names)
