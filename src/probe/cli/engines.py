"""Which engine does the work: options of commands that have much of it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

from probe.cli.screen import say
from probe.engines.local import LocalEngine
from probe.engines.plan import Engine
from probe.engines.ray_engine import RayEngine
from probe.errors import BadData


@dataclass(frozen=True)
class EngineChoice:
    """Where the work is done.

    Attributes:
        on: "local" for processes of this machine, "ray" for the nodes of a Ray cluster: see
            docs/how-to/many-machines.md.
        store: Address of an object store ("s3://bucket/run") by way of which nodes of a Ray
            cluster get assets and return results, if they don't share a file system.
    """

    on: Literal["local", "ray"] = "local"
    store: str | None = None

    def refuse_for_models(self) -> None:
        """Refuse a cluster for models, which are asked from one machine.

        Raises:
            BadData: One is asked for.
        """
        if self != EngineChoice():
            remedy = "Use --shard I/N on each machine"
            raise BadData("--on", "models are asked from one machine", remedy)

    def engine(
        self,
        out: Path,
        workers: int | None,
        tell: Callable[[str], object] = say,
        *,
        usual: int = 1,
    ) -> Engine:
        """The engine for work whose results go to a folder.

        Args:
            out: The folder.
            workers: Processes; None for the usual number here, and for one on each core of a
                cluster.
            tell: Is told what a person should know.
            usual: Processes here, if nobody says otherwise.

        Raises:
            BadData: An option would do nothing.
        """
        if self.on == "ray":
            return RayEngine(out, self.store, workers, tell)
        if self.store is not None:
            raise BadData("--store", "does nothing without --on ray", "Leave it out")
        return LocalEngine(workers or usual)
