"""Whether what was given as the address of a server can be one; asks nobody."""

from __future__ import annotations

from urllib.parse import urlsplit

from probe.errors import BadData


def check_address(endpoint: str | None) -> None:
    """See that it is an address: a scheme, a host, and a port that there can be.

    Raises:
        BadData: It isn't.
    """
    if endpoint is None:
        return
    if not endpoint.startswith(("http://", "https://")):
        remedy = "Begin it with http:// or https://"
        raise BadData("--endpoint", f"{endpoint!r} is no address of a server", remedy)
    remedy = "Say one such as http://localhost:8000/v1"
    if any(sign.isspace() or not sign.isprintable() for sign in endpoint):
        raise BadData("--endpoint", f"{endpoint!r} has spaces or control characters in it", remedy)
    try:
        parts = urlsplit(endpoint)
        host, port = parts.hostname, parts.port
    except ValueError as error:  # a port that is no number or over 65,535; half a bracket
        reason = f"{endpoint!r} is no address of a server ({error})"
        raise BadData("--endpoint", reason, remedy) from error
    if not host:
        raise BadData("--endpoint", f"{endpoint!r} names no server", remedy)
    if port == 0:
        raise BadData("--endpoint", f"{endpoint!r}: nobody can listen at port 0", remedy)
