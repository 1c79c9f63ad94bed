"""What an agent in a process of its own is allowed, and how it is found."""

from __future__ import annotations

import stat
from dataclasses import dataclass
from pathlib import Path

from probe.errors import BadData

START_SECONDS = 120.0
"""Wall time that a file may take to be loaded and to make an agent."""

_LEAST_GB = 0.25
_SAY = "Say --agent FILE.py:ClassName"


@dataclass(frozen=True)
class Sandbox:
    """What an agent given by file is allowed; it does nothing for others.

    Attributes:
        seconds: Wall time of each call of act(); an agent that takes longer has stopped.
        memory_gb: Address space of each of its processes, in GB.
        network: Let it use the network.
        files: Files and folders that it may read beside its own file; modules are found there.
    """

    seconds: float = 60.0
    memory_gb: float = 8.0
    network: bool = False
    files: tuple[Path, ...] = ()

    def check(self) -> None:
        """See that it can be done.

        Raises:
            BadData: It can't.
        """
        if not 0 < self.seconds < 1e6:
            raise BadData("--sandbox.seconds", f"is {self.seconds:g}", "Say more than 0")
        if not _LEAST_GB <= self.memory_gb < 1e6:
            reason = f"is {self.memory_gb:g}, too little for an interpreter"
            raise BadData("--sandbox.memory-gb", reason, f"Say {_LEAST_GB} or more")
        for path in self.files:
            if not path.exists():
                raise BadData(path, "there is no such file or folder", "Check --sandbox.files")


@dataclass(frozen=True)
class AgentFile:
    """Where an agent comes from.

    Attributes:
        path: A Python file.
        name: A class or function in it that makes the agent; None for its only class with act().
    """

    path: Path
    name: str | None = None

    @staticmethod
    def of(text: str) -> AgentFile:
        """From "FILE.py" or "FILE.py:Name".

        Raises:
            BadData: There is no such file.
        """
        path, _, name = text.partition(".py:")
        file = Path(f"{path}.py" if name else text)
        try:
            mode = file.stat().st_mode
            resolved = file.resolve()
        except FileNotFoundError as error:
            raise BadData(file, "there is no such file", _SAY) from error
        except OSError as error:  # a name that is too long, a loop of links
            raise BadData(file, error.strerror or str(error), _SAY) from error
        if not stat.S_ISREG(mode):
            raise BadData(file, "is no regular file", _SAY)
        return AgentFile(resolved, name or None)
