"""Workers on the nodes of a Ray cluster; the death of one, or of a node, costs no more than time.

Results don't come through Ray: each worker writes its own into the result store, where it stands
until the driver has kept it. So a driver that is killed finds them when it comes back.
"""

from __future__ import annotations

import socket
from collections import deque
from collections.abc import Callable, Generator
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from probe.assets.folders import assets_folder, library_folder
from probe.engines.asset_bundle import publish
from probe.engines.cluster_watch import ClusterWatch
from probe.engines.node import MARK, NodeSetup, code_digest
from probe.engines.plan import LostUnit, Unit, WorkPlan
from probe.engines.ray_cluster import connected
from probe.engines.ray_crew import Crew
from probe.engines.result_store import ResultStore
from probe.errors import BadData


@dataclass(frozen=True)
class RayEngine:
    """The nodes of a Ray cluster; see probe.engines.plan.Engine.

    Attributes:
        home: The run's folder; results come by way of it, unless there is a store.
        store: Address of an object store for results and assets; None if all nodes see `home`.
        workers: Processes at most, of a core each; None for one on each core of the cluster.
        tell: Is told what a person should know: a node that can't work, a wait.
    """

    home: Path
    store: str | None = None
    workers: int | None = None
    tell: Callable[[str], object] = print

    def carry_out(self, plan: WorkPlan[Unit]) -> Generator[tuple[Unit, bytes | LostUnit]]:
        """Do all units on the cluster; see Engine.

        Raises:
            ClusterRefused: There is no cluster, or it doesn't let us in.
            BadData: The store is in use by another run, or can't be read.
            OutputFailed: The store can't be written.
        """
        results = self._results(plan.name)
        self._check_free(results)
        units = {plan.key(unit): unit for unit in plan.units}
        finished = results.read_all(sorted(results.names() & units.keys()))
        for key, content in finished.items():
            yield units.pop(key), content
        results.sweep({MARK})
        with self._claimed(results):
            if units:
                with connected(self.tell) as (ray, address):
                    watch = ClusterWatch(address, f"{self.home} and {results.url}", self.tell)
                    count, node = self._count(ray, len(units)), self._node(results)
                    crew = Crew(ray, plan, node, count, self.tell, watch)
                    yield from crew.results(deque((unit, 1) for unit in units.values()))

    @contextmanager
    def _claimed(self, results: ResultStore) -> Generator[None]:
        """Hold the store; results that are still to be kept stay in it if it ends early."""
        results.write(MARK, self._driver)
        try:
            yield
        except BaseException:
            with suppress(BadData):  # what ended it says more
                if results.names() <= {MARK}:
                    results.sweep()
            raise
        results.sweep()

    def _results(self, name: str) -> ResultStore:
        if self.store is None:
            return ResultStore(str(self.home.resolve() / f"units-{name}"))
        return ResultStore(self.store.rstrip("/")).under(f"units-{name}")

    def _check_free(self, results: ResultStore) -> None:
        """Refuse a store to which another driver's results go."""
        if results.has(MARK) and results.read(MARK) != self._driver:
            whose = results.read(MARK).decode(errors="replace")
            remedy = f"Say another --store, or delete {results.url}/{MARK} if that run is over"
            raise BadData(results.url, f"is in use by the run of {whose}", remedy)

    @property
    def _driver(self) -> bytes:
        return f"{socket.gethostname()}:{self.home.resolve()}".encode()

    def _node(self, results: ResultStore) -> NodeSetup:
        folders = {"PROBE_ASSETS": assets_folder(), "PROBE_LIBRARY": library_folder()}
        named = {name: path.resolve() for name, path in folders.items() if path and path.exists()}
        if self.store is None:
            seen = {name: str(path) for name, path in named.items()}
            return NodeSetup(code_digest(), results, seen)
        assets = ResultStore(self.store.rstrip("/")).under("assets")
        fetched = {name: publish(path, assets) for name, path in named.items()}
        return NodeSetup(code_digest(), results, bundles=fetched)

    def _count(self, ray: Any, units: int) -> int:
        cores = int(ray.cluster_resources().get("CPU", 0))
        return min(self.workers or max(1, cores), units)
