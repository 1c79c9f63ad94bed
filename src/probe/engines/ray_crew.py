"""The workers of one plan on a Ray cluster: who is at which unit, and who replaces the dead."""

from __future__ import annotations

import time
from collections import deque
from collections.abc import Callable, Generator
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, Generic

from probe.engines.cluster_watch import ClusterWatch
from probe.engines.node import NodeSetup
from probe.engines.plan import TRIES, LostUnit, Unit, WorkPlan
from probe.engines.ray_worker import NodeReport, RayWorker
from probe.errors import WorkerDied
from probe.processes.serving import WorkerUnfit

_PATIENCE = 60.0
"""Seconds without any news after which we say what is being waited for."""

_DOING = f"setting up on a node, and so did the {TRIES - 1} before it"
_REMEDY = "Ray's logs tell why (most often memory). The same command goes on from what is done."


@dataclass(eq=False)
class _Member(Generic[Unit]):
    """A worker, and what it is at; at nothing while it opens."""

    actor: Any
    node: str = ""
    unit: Unit | None = None
    tries: int = 0


@dataclass
class Crew(Generic[Unit]):
    """Workers, of which each has a core of some node.

    Attributes:
        ray: Connected to the cluster.
        plan: What they do.
        node: How each prepares.
        count: How many there may be.
        tell: Is told what a person should know.
        watch: Over the cluster's first machine.
        stillborn: How many have died in a row before they were ready.
        told: What has been told of nodes.
        members: The workers, by the call that each is at.
    """

    ray: Any
    plan: WorkPlan[Unit]
    node: NodeSetup
    count: int
    tell: Callable[[str], object]
    watch: ClusterWatch
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
            while waiting or self._working:
                self._hire(len(waiting))
                heard = [self._hear(said, waiting) for said in self._news()]
                yield from self._kept([event for event in heard if event is not None])
        finally:
            self._disband()

    @property
    def _working(self) -> bool:
        """Whether a worker is at a unit."""
        return any(member.unit is not None for member in self.members.values())

    def _disband(self) -> None:
        """End all workers; those of a lost cluster end by themselves, and Ray would wait for it."""
        if self.members and self.watch.address.answers():
            for member in self.members.values():
                self.ray.kill(member.actor)

    def _hire(self, waiting: int) -> None:
        """Start workers for what waits, as many as there may be.

        Once several have died in a row before they were ready, none until another ends a unit.
        """
        if self.stillborn >= TRIES and self._working:
            return
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
        began = time.monotonic()
        while True:
            self.watch.look()
            open_calls = list(self.members)
            said, _ = self.ray.wait(open_calls, num_returns=1, timeout=self.watch.every)
            if said:
                return self.ray.wait(open_calls, num_returns=len(open_calls), timeout=0)[0]
            if time.monotonic() - began < _PATIENCE:
                continue
            began = time.monotonic()
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
        self.stillborn, member.node = 0, report.node
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
            WorkerDied: Workers die before they begin, and none is at work.
        """
        if member.unit is None:
            self.stillborn += 1
            if self.stillborn >= TRIES and not self._working:
                raise WorkerDied(_DOING, _REMEDY)
            return None
        self._tell_once(NodeReport(member.node, "A worker died."), "Another one does its work.")
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
        self._tell_once(report, "The other workers go on.")

    def _tell_once(self, report: NodeReport, more: str) -> None:
        """Tell what is wrong with a node; other workers of it may say the same."""
        if report not in self.told:
            self.told.add(report)
            self.tell(f"{report.node}: {report.problem} {more}")
