"""The way into a Ray cluster: Ray itself, and a cluster that lets in only who has its token."""

from __future__ import annotations

import os
import sys
from collections.abc import Generator
from contextlib import contextmanager
from importlib import import_module
from pathlib import Path
from typing import Any

from probe.errors import MissingExtra, ProbeError

_TOKEN_REMEDY = (
    "Make a token (`ray get-auth-token --generate`), and export RAY_AUTH_MODE=token and "
    "RAY_AUTH_TOKEN=... for every `ray start` and here"
)


class ClusterRefused(ProbeError):
    """There is no cluster that can be used."""

    def __init__(self, where: str, reason: str, remedy: str) -> None:
        super().__init__(
            f"--on ray: {where}: {reason}. {remedy}; see docs/how-to/many-machines.md."
        )


@contextmanager
def connected() -> Generator[Any]:
    """Ray, connected to the cluster of RAY_ADDRESS or else to the one that runs on this machine.

    Raises:
        MissingExtra: Ray isn't installed.
        ClusterRefused: There is no token, it is the wrong one, or no cluster is there.
    """
    where = os.environ.get("RAY_ADDRESS") or "the cluster of this machine"
    _check_token(where)
    try:
        ray = import_module("ray")
    except ImportError as error:
        raise MissingExtra("--on ray", "ray") from error
    try:
        with _quiet():
            ray.init(
                address=os.environ.get("RAY_ADDRESS") or "auto",
                log_to_driver=False,
                logging_level="ERROR",
            )
    except ray.exceptions.AuthenticationError as error:
        raise ClusterRefused(where, "it didn't take this token", _TOKEN_REMEDY) from error
    except ConnectionError as error:
        raise ClusterRefused(where, _why(str(error)), _remedy(str(error))) from error
    try:
        yield ray
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


def _check_token(where: str) -> None:
    """Refuse a cluster that anybody could send code to, before anything is sent there."""
    if os.environ.get("RAY_AUTH_MODE") != "token":
        raise ClusterRefused(where, "RAY_AUTH_MODE isn't token", _TOKEN_REMEDY)
    named = os.environ.get("RAY_AUTH_TOKEN_PATH")
    file = Path(named) if named else Path.home() / ".ray" / "auth_token"
    if not os.environ.get("RAY_AUTH_TOKEN") and not file.exists():
        reason = f"there is no token, neither in RAY_AUTH_TOKEN nor in {file}"
        raise ClusterRefused(where, reason, _TOKEN_REMEDY)


def _why(said: str) -> str:
    if "Could not find any running Ray" in said:
        return "no Ray runs here"
    return "it didn't let us in; it doesn't run, or has another token"


def _remedy(said: str) -> str:
    if "Could not find any running Ray" in said:
        return "Start one (`ray start --head`), or export RAY_ADDRESS=HOST:PORT"
    return "Export the cluster's own RAY_AUTH_TOKEN, and see that the address can be reached"
