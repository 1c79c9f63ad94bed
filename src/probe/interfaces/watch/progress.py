"""How many episodes of an agent a run's folder holds, read as it grows."""

from __future__ import annotations

import json
import threading
from pathlib import Path


class RecordCount:
    """Counts an agent's episodes; those that failed on our side are run again and don't count.

    Args:
        records: The file; it needn't exist yet.
        agent: Name of the agent.
        setting: How it may answer; empty for agents without a model.
    """

    def __init__(self, records: Path, agent: str, setting: str) -> None:
        self._records = records
        self._who = agent, setting
        self._read = 0
        self._done: set[tuple[str, int]] = set()
        self._lock = threading.Lock()

    def done(self) -> int:
        """How many there are by now; only what has been added since is read."""
        with self._lock:
            if self._records.exists():
                self._take_in()
            return len(self._done)

    def _take_in(self) -> None:
        with self._records.open("rb") as file:
            file.seek(self._read)
            for line in file:
                if not line.endswith(b"\n"):
                    break
                self._read += len(line)
                said = json.loads(line)
                seat: dict[str, str] = said["seat"] or {}
                if (said["agent"], seat.get("arm", "")) == self._who and said["end"] != "fault":
                    self._done.add((said["task"], said["run"]))
