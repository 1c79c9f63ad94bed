"""Why no reply came, in one line: what a server said, or that nobody is there. Asks nothing."""

from __future__ import annotations

import re
from collections.abc import Iterator

from probe.texts import writable

_UNLIKE_THE_PROTOCOL = {
    "APIResponseValidationError", "AssertionError", "AttributeError", "IndexError",
    "JSONDecodeError", "KeyError", "TypeError", "UnicodeDecodeError", "ValidationError",
}  # fmt: skip
"""What clients raise over a field that is missing or has another type, and text that is none."""

LONGEST = 200
"""Characters of what a server says that a record keeps."""


def said(error: BaseException) -> str:
    """What a server said; the harness's own words begin with the whole request.

    What it wraps an error in after the last of many attempts says nothing of the error.
    """
    inner = next(each for each in _chain(error) if not hasattr(each, "last_attempt"))
    words = getattr(inner, "provider_message", None) or str(inner)
    status = getattr(inner, "status_code", None)
    lost = unreached(inner)
    text = " ".join(f"{status or ''} {words} {f'({lost})' if lost else ''}".split())
    return explained(f"{type(inner).__name__}: {writable(text[:LONGEST])}")


def explained(reason: str) -> str:
    """A reason that begins with an error's name, with what that error means of a reply."""
    name = re.split(r"\W", reason, maxsplit=1)[0]
    if name not in _UNLIKE_THE_PROTOCOL:
        return reason
    return f"its reply doesn't follow the protocol ({reason})"


def unreached(error: BaseException) -> str | None:
    """Why a server couldn't be spoken to at all; None if it said something."""
    for each in _chain(error):
        if isinstance(each, TimeoutError):
            return "no answer in time"
        if isinstance(each, OSError) and each.errno is not None:
            return (each.strerror or str(each)).partition(" (")[0]
    return None


def _chain(error: BaseException) -> Iterator[BaseException]:
    """An error and what led to it, each once."""
    seen: set[int] = set()
    each: BaseException | None = error
    while each is not None and id(each) not in seen:
        seen.add(id(each))
        yield each
        each = each.__cause__ or each.__context__
