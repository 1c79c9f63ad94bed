"""What goes wrong between us and a Ray cluster."""

from __future__ import annotations

from probe.errors import ProbeError


class ClusterRefused(ProbeError):
    """There is no cluster that can be used."""

    def __init__(self, where: str, reason: str, remedy: str) -> None:
        super().__init__(
            f"--on ray: {where}: {reason}. {remedy}; see docs/how-to/many-machines.md."
        )


class ClusterLost(ProbeError):
    """The cluster's first machine is gone in mid-run."""

    def __init__(self, where: str, kept: str) -> None:
        super().__init__(
            f"--on ray: {where}: the cluster's first machine doesn't answer any more. What was "
            f"finished is kept in {kept}. Start the cluster again; the same command goes on."
        )
