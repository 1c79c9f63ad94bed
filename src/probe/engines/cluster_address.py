"""Where a Ray cluster's first machine is, and whether anything answers there. Sends nothing."""

from __future__ import annotations

import os
import socket
from dataclasses import dataclass
from importlib import import_module

from probe.engines.ray_errors import ClusterRefused

_START = "Start one (`ray start --head --port=6379`) or export RAY_ADDRESS=HOST:PORT of one"
_CONNECTING = 5.0
"""Seconds after which a machine that says neither yes nor no counts as silent."""


@dataclass(frozen=True)
class ClusterAddress:
    """Where the first machine listens.

    Attributes:
        host: Its name or number.
        port: Of Ray on it.
        source: Who says so, in words.
    """

    host: str
    port: int
    source: str

    def __str__(self) -> str:
        return f"{self.host}:{self.port} (from {self.source})"

    @property
    def bare(self) -> str:
        """The address as Ray takes it."""
        return f"{self.host}:{self.port}"

    def answers(self) -> bool:
        """Whether anything listens there."""
        try:
            socket.create_connection((self.host.strip("[]"), self.port), _CONNECTING).close()
        except OSError:
            return False
        return True

    def require(self) -> None:
        """See that something listens there.

        Raises:
            ClusterRefused: Nothing does.
        """
        if not self.answers():
            raise ClusterRefused(str(self), "no cluster answers there", _START)


def cluster_address() -> ClusterAddress:
    """The address in RAY_ADDRESS, or else of the cluster that Ray finds on this machine.

    Raises:
        ClusterRefused: There is none, or it isn't HOST:PORT.
    """
    named = os.environ.get("RAY_ADDRESS", "")
    if named not in ("", "auto"):
        return _parsed(named, "RAY_ADDRESS")
    try:
        found = import_module("ray._private.services").get_ray_address_from_environment(
            "auto", None
        )
    except ConnectionError as error:
        reason = "no Ray runs here, and RAY_ADDRESS isn't set"
        raise ClusterRefused("this machine", reason, _START) from error
    utils = import_module("ray._private.utils")
    noted = found == utils.read_ray_address()
    return _parsed(found, utils.get_ray_address_file(None) if noted else "Ray on this machine")


def _parsed(address: str, source: str) -> ClusterAddress:
    host, _, port = address.rpartition(":")
    if "/" in host or not host or not port.isdecimal() or int(port) > 65535:
        raise ClusterRefused(f"{address} (from {source})", "isn't HOST:PORT", _START)
    return ClusterAddress(host, int(port), source)
