"""What a server is told, by variables of its environment: a container has no other way."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from probe.errors import BadData


@dataclass(frozen=True)
class Settings:
    """What is played, and by how many at once.

    Attributes:
        suite: PROBE_SUITE: file of tasks for training.
        tables: PROBE_TABLES: episodes at once; each takes a process of about 0.8 GB.
        out: PROBE_OUT: folder for the records; None to keep none.
    """

    suite: Path
    tables: int = 8
    out: Path | None = None

    @staticmethod
    def of_environment(variables: Mapping[str, str] = os.environ) -> Settings:
        """As the variables say.

        Raises:
            BadData: PROBE_SUITE is missing, or PROBE_TABLES is no number of tables.
        """
        if not (suite := variables.get("PROBE_SUITE")):
            remedy = "Set it to a file that `probe suite build --pool train` wrote"
            raise BadData("PROBE_SUITE", "is not set", remedy)
        tables = variables.get("PROBE_TABLES", "8")
        if not tables.isdecimal() or int(tables) < 1:
            raise BadData("PROBE_TABLES", f"{tables!r} is no number of tables", "Say 1 or more")
        out = variables.get("PROBE_OUT")
        return Settings(Path(suite), int(tables), Path(out) if out else None)

    def variables(self) -> dict[str, str]:
        """The variables that say so."""
        said = {"PROBE_SUITE": str(self.suite), "PROBE_TABLES": str(self.tables)}
        return said if self.out is None else {**said, "PROBE_OUT": str(self.out)}
