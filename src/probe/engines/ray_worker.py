"""What a process on a node does: prepares once, then does unit after unit. Knows no Ray."""

from __future__ import annotations

import socket
from collections.abc import Callable
from contextlib import ExitStack
from dataclasses import dataclass
from typing import Generic

from probe.engines.node import NodeSetup
from probe.engines.plan import Unit
from probe.errors import OutputFailed, ProbeError
from probe.processes.serving import Opening


@dataclass(frozen=True)
class NodeReport:
    """What a worker says of itself.

    Attributes:
        node: Where it is.
        problem: Why it can't work; None if it can.
    """

    node: str
    problem: str | None = None


class RayWorker(Generic[Unit]):
    """A worker of a cluster; an actor, so that its library and renderer stay warm.

    Args:
        opening: Sets up what does a unit.
        node: What this machine must have.
    """

    def __init__(self, opening: Opening[Unit, bytes], node: NodeSetup) -> None:
        self._opening = opening
        self._node = node
        self._stack = ExitStack()
        self._do: Callable[[Unit], bytes] | None = None

    def open(self) -> NodeReport:
        """Prepare."""
        try:
            self._node.prepare()
            self._do = self._stack.enter_context(self._opening())
        except (ProbeError, MemoryError, ImportError, OSError) as error:
            return NodeReport(socket.gethostname(), str(error) or type(error).__name__)
        return NodeReport(socket.gethostname())

    def do(self, unit: Unit, key: str) -> NodeReport:
        """Do a unit and write its result; a problem is the node's, never the unit's."""
        assert self._do is not None, "a worker is opened first"
        try:
            self._node.results.write(key, self._do(unit))
        except OutputFailed as error:  # the disk, or the store
            return NodeReport(socket.gethostname(), str(error))
        return NodeReport(socket.gethostname())

    def close(self) -> None:
        """End what was set up."""
        self._stack.close()
