"""Workers on the nodes of a Ray cluster; the death of one, or of a node, costs no more than time.

Results don't come through Ray: each worker writes its own into the result store, where it stands
until the driver has kept it. So a driver that is killed finds them when it comes back.
"""

from __future__ import annotations

import socket
from collections import deque
from collections.abc import Callable, Generator
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Any, Generic

from probe.assets.folders import assets_folder, library_folder
from probe.engines.asset_bundle import publish
from probe.engines.node import MARK, NodeSetup, code_digest
from probe.engines.plan import TRIES, LostUnit, Unit, WorkPlan
from probe.engines.ray_cluster import connected
from probe.engines.ray_worker import NodeReport, RayWorker
from probe.engines.result_store import ResultStore
from probe.errors import BadData, WorkerDied
from probe.processes.serving import WorkerUnfit

_PATIENCE = 60.0
"""Seconds without any news after which we say what is being waited for."""


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
        self._claim(results)
        units = {plan.key(unit): unit for unit in plan.units}
        finished = results.read_all(sorted(results.names() & units.keys()))
        for key, content in finished.items():
            yield units.pop(key), content
        results.sweep({MARK})
        results.write(MARK, self._driver)
        if units:
            with connected() as ray:
                crew = _Crew(
                    ray, plan, self._node(results), self._count(ray, len(units)), self.tell
                )
                yield from crew.results(deque((unit, 1) for unit in units.values()))
        results.sweep()

    def _results(self, name: str) -> ResultStore:
        if self.store is None:
            return ResultStore(str(self.home.resolve() / f"units-{name}"))
        return ResultStore(self.store.rstrip("/")).under(f"units-{name}")

    def _claim(self, results: ResultStore) -> None:
        """Take up the store, unless another driver's results go there."""
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


@dataclass(eq=False)
class _Member(Generic[Unit]):
    """A worker, and what it is at; at nothing while it opens."""

    actor: Any
    unit: Unit | None = None
    tries: int = 0


@dataclass
class _Crew(Generic[Unit]):
    ray: Any
    plan: WorkPlan[Unit]
    node: NodeSetup
    count: int
    tell: Callable[[str], object]
    stillborn: int = 0
    told: set[NodeReport] = field(default_factory=set[NodeReport])
    members: dict[Any, _Member[Unit]] = field(default_factory=dict[Any, "_Member[Unit]"])

    @cached_property
    def workers(self) -> Any:
        """What starts a worker on some node."""
        return self.ray.remote(num_cpus=1, max_restarts=0)(RayWorker)

    def results(self, waiting: deque[tuple[Unit, int]]) -> Generator[tuple[Unit, bytes | LostUnit]]:
        """Do what waits; a unit's result is removed from the store once it is kept."""
        try:
            while waiting or any(member.unit is not None for member in self.members.values()):
                self._hire(len(waiting))
                heard = [self._hear(said, waiting) for said in self._news()]
                yield from self._kept([event for event in heard if event is not None])
        finally:
            for member in self.members.values():
                self.ray.kill(member.actor)

    def _hire(self, waiting: int) -> None:
        """Start workers for what waits, as many as there may be."""
        opening = sum(member.unit is None for member in self.members.values())
        for _ in range(min(self.count - len(self.members), waiting - opening)):
            actor = self.workers.remote(self.plan.opening, self.node)
            self.members[actor.open.remote()] = _Member(actor)

    def _kept(
        self, ended: list[tuple[Unit, LostUnit | None]]
    ) -> Generator[tuple[Unit, bytes | LostUnit]]:
        """Fetch results together, since each trip to an object store takes its time."""
        keys = [self.plan.key(unit) for unit, lost in ended if lost is None]
        found = self.node.results.read_all(keys)
        for unit, lost in ended:
            yield unit, lost or found[self.plan.key(unit)]
        self.node.results.remove_all(keys)

    def _news(self) -> list[Any]:
        """All that workers have said since; waits until one says something."""
        while True:
            open_calls = list(self.members)
            said, _ = self.ray.wait(open_calls, num_returns=1, timeout=_PATIENCE)
            if said:
                return self.ray.wait(open_calls, num_returns=len(open_calls), timeout=0)[0]
            free = self.ray.available_resources().get("CPU", 0)
            if all(member.unit is None for member in self.members.values()) and not free:
                self.tell("No core of the cluster is free; waiting for one.")

    def _hear(
        self, said: Any, waiting: deque[tuple[Unit, int]]
    ) -> tuple[Unit, LostUnit | None] | None:
        """Take in what a worker says and give it the next unit; a unit that ended, if any."""
        member = self.members.pop(said)
        unit = member.unit
        try:
            report: NodeReport = self.ray.get(said)
        except self.ray.exceptions.RayError as error:
            lost = self._bury(member, error, waiting)
            return None if unit is None or lost is None else (unit, lost)
        if report.problem is not None:
            self._dismiss(member, report, waiting)
            return None
        self.stillborn = 0
        self._occupy(member, waiting)
        return None if unit is None else (unit, None)

    def _occupy(self, member: _Member[Unit], waiting: deque[tuple[Unit, int]]) -> None:
        """Give a worker the next unit, or let it go home."""
        if not waiting:
            member.actor.close.remote()
            member.actor.__ray_terminate__.remote()
            return
        member.unit, member.tries = waiting.popleft()
        said = member.actor.do.remote(member.unit, self.plan.key(member.unit))
        self.members[said] = member

    def _bury(
        self, member: _Member[Unit], error: Exception, waiting: deque[tuple[Unit, int]]
    ) -> LostUnit | None:
        """Have a dead worker's unit begun again; lost if it was begun TRIES times.

        Raises:
            WorkerDied: Workers die before they begin.
        """
        if member.unit is None:
            self.stillborn += 1
            if self.stillborn >= TRIES:
                raise WorkerDied("setting up on a node")
            return None
        if member.tries < TRIES:
            waiting.appendleft((member.unit, member.tries + 1))
            return None
        reason = str(error).partition("\n")[0]
        return LostUnit(f"A worker on a node died at it, {TRIES} times in all: {reason}")

    def _dismiss(
        self, member: _Member[Unit], report: NodeReport, waiting: deque[tuple[Unit, int]]
    ) -> None:
        """Do without a worker whose node can't work; its unit goes to another.

        Raises:
            WorkerUnfit: There is no other.
        """
        self.ray.kill(member.actor)
        if member.unit is not None:
            waiting.appendleft((member.unit, member.tries))
        self.count -= 1
        if self.count == 0:
            raise WorkerUnfit(f"{report.node}: {report.problem}")
        # Ray may start another worker on the same node, which says the same.
        if report not in self.told:
            self.told.add(report)
            self.tell(f"{report.node}: {report.problem} The other workers go on.")
