"""Who may ask, and what a page may load: this machine's own pages alone."""

from __future__ import annotations

from starlette.datastructures import Headers, MutableHeaders
from starlette.middleware import Middleware
from starlette.middleware.trustedhost import TrustedHostMiddleware
from starlette.responses import JSONResponse
from starlette.types import ASGIApp, Message, Receive, Scope, Send

HOSTS = ("127.0.0.1", "localhost")
"""Names that a browser here may know us by; other names may belong to somebody else's page."""

_HEADERS = {
    "content-security-policy": "default-src 'none'; script-src 'self'; style-src 'self'; "
    "img-src 'self'; connect-src 'self'; form-action 'self'; base-uri 'none'; "
    "frame-ancestors 'none'",
    "cross-origin-resource-policy": "same-origin",
    "cross-origin-opener-policy": "same-origin",
    "x-content-type-options": "nosniff",
    "referrer-policy": "no-referrer",
    "cache-control": "no-store",
}


def guards(most_bytes: int) -> list[Middleware]:
    """In the order in which a request meets them.

    Args:
        most_bytes: That a request may send.
    """
    return [
        Middleware(_Headed),
        Middleware(TrustedHostMiddleware, allowed_hosts=list(HOSTS), www_redirect=False),
        Middleware(_OwnPagesAlone, most_bytes=most_bytes),
    ]


class _Headed:
    """Every reply says what may be done with it."""

    def __init__(self, app: ASGIApp) -> None:
        self._app = app

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        async def headed(message: Message) -> None:
            if message["type"] == "http.response.start":
                MutableHeaders(scope=message).update(_HEADERS)
            await send(message)

        await self._app(scope, receive, headed)


class _OwnPagesAlone:
    """Refuses what another site's page sends through the same browser, and what is too long.

    A browser asks before it sends JSON elsewhere, and it isn't allowed to; Origin is checked
    beside that.
    """

    def __init__(self, app: ASGIApp, most_bytes: int) -> None:
        self._app = app
        self._most = most_bytes

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        refusal = self._refusal(scope) if scope["type"] == "http" else None
        if refusal is None:
            await self._app(scope, receive, send)
        else:
            status, words = refusal
            await JSONResponse({"error": words}, status)(scope, receive, send)

    def _refusal(self, scope: Scope) -> tuple[int, str] | None:
        headers = Headers(scope=scope)
        origin = headers.get("origin")
        if origin is not None and origin != f"http://{headers.get('host')}":
            return 403, "Another site's page sent this; only our own may."
        if scope["method"] != "POST":
            return None
        if headers.get("content-type", "").split(";")[0].strip() != "application/json":
            return 415, "Only JSON is taken."
        length = headers.get("content-length", "")
        if not length.isdecimal():
            return 411, "How long it is has to be said beforehand."
        return (413, "That is too long.") if int(length) > self._most else None
