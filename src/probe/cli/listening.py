"""Whether anything listens at a model's address on this machine, before hours are spent on it."""

from __future__ import annotations

import socket
from urllib.parse import urlsplit

from probe.errors import ModelFailed

_SECONDS = 5.0
_HERE = ("localhost", "127.0.0.1", "::1")
_PORTS = {"http": 80, "https": 443}


def check_listening(model: str, endpoint: str | None) -> None:
    """See that a server on this machine is there; others may be reached by way of a proxy.

    Raises:
        ModelFailed: Nothing listens there.
    """
    parts = urlsplit(endpoint or "")
    if parts.hostname not in _HERE:
        return
    try:
        port = parts.port or _PORTS[parts.scheme]
        socket.create_connection((parts.hostname, port), _SECONDS).close()
    except OSError as error:
        reason = (error.strerror or str(error)).lower()
        remedy = "Start the server there, or say where it is with --endpoint"
        words = f"{model} doesn't answer: {endpoint} can't be reached ({reason}). {remedy}."
        raise ModelFailed(words) from error
