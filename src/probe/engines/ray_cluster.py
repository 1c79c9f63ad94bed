"""The way into a Ray cluster: Ray itself, and a cluster that lets in only who has its token."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Generator
from contextlib import contextmanager
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from probe.engines.cluster_address import ClusterAddress, cluster_address
from probe.engines.ray_errors import ClusterRefused
from probe.errors import MissingExtra

_TOKEN_REMEDY = (
    "Make a token (`ray get-auth-token --generate`), and export RAY_AUTH_MODE=token and "
    "RAY_AUTH_TOKEN=... for every `ray start` and here"
)
_ENTRY_REMEDY = (
    "See that a Ray of the same version listens there, and that this machine is one of its nodes"
)


@contextmanager
def connected(tell: Callable[[str], object]) -> Generator[tuple[Any, ClusterAddress]]:
    """Ray, connected to the cluster of RAY_ADDRESS or else to the one that runs on this machine.

    Args:
        tell: Is told the address before anything is asked of it.

    Raises:
        MissingExtra: Ray isn't installed.
        ClusterRefused: There is no token, it is the wrong one, or no cluster is there.
    """
    _check_token()
    if find_spec("ray") is None:
        raise MissingExtra("--on ray", "ray")
    address = cluster_address()
    tell(f"Connecting to the Ray cluster at {address}.")
    address.require()
    ray = import_module("ray")
    try:
        with _quiet():
            # Of a wrong token this hears at once; ray.init tries it for half a minute.
            import_module("ray._raylet").GcsClient(address=address.bare)
            ray.init(address=address.bare, log_to_driver=False, logging_level="ERROR")
    except ray.exceptions.AuthenticationError as error:
        raise ClusterRefused(str(address), "it has another token", _TOKEN_REMEDY) from error
    except (ray.exceptions.RpcError, ConnectionError, RuntimeError) as error:
        reason = f"it didn't let us in ({str(error).partition(chr(10))[0].rstrip('.')})"
        raise ClusterRefused(str(address), reason, _ENTRY_REMEDY) from error
    # What Ray prints of deaths, in colour, we tell ourselves; no setting of ray.init quiets it.
    worker: Any = import_module("ray._private.worker")
    worker._worker_logs_enabled = False
    try:
        yield ray, address
    finally:
        ray.shutdown()


@contextmanager
def _quiet() -> Generator[None]:
    """Nothing goes to stderr: Ray tells each attempt to get in, and we tell the outcome."""
    sys.stderr.flush()
    kept, nothing = os.dup(2), os.open(os.devnull, os.O_WRONLY)
    try:
        os.dup2(nothing, 2)
        yield
    finally:
        os.dup2(kept, 2)
        os.close(kept)
        os.close(nothing)


def _check_token() -> None:
    """Refuse a cluster that anybody could send code to, before anything is sent there."""
    where = os.environ.get("RAY_ADDRESS") or "the cluster of this machine"
    if os.environ.get("RAY_AUTH_MODE") != "token":
        raise ClusterRefused(where, "RAY_AUTH_MODE isn't token", _TOKEN_REMEDY)
    named = os.environ.get("RAY_AUTH_TOKEN_PATH")
    file = Path(named) if named else Path.home() / ".ray" / "auth_token"
    if not os.environ.get("RAY_AUTH_TOKEN") and not file.exists():
        reason = f"there is no token, neither in RAY_AUTH_TOKEN nor in {file}"
        raise ClusterRefused(where, reason, _TOKEN_REMEDY)
