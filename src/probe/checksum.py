"""The checksum that a JSON object ends with, so that no byte of it changes unnoticed.

It is against accidents: who changes an object on purpose can make a new one.
"""

from __future__ import annotations

import hashlib
import re

_END = re.compile(rb',"sum":"([^"]*)"\}\n?\Z')
_REWRITTEN = re.compile(rb'"sum"\s*:\s*"[^"]*"\s*\}\s*\Z')
_LENGTH = len(',"sum":""}\n') + 64
"""No checksum takes up more bytes than this at the end of an object."""


def with_sum(text: bytes) -> bytes:
    """A JSON object with the checksum of its bytes as one more field, its last, and a line end."""
    body = text.rstrip().removesuffix(b"}").rstrip()
    return body + b',"sum":"' + _sum(body) + b'"}\n'


def has_sum(text: bytes) -> bool:
    """Whether a JSON object ends with a checksum, be it right or wrong."""
    return _END.search(text, max(0, len(text) - _LENGTH)) is not None


def without_sum(text: bytes) -> bytes:
    """A JSON object without its checksum; as it is if it has none.

    Raises:
        ValueError: It isn't the checksum of what stands before it, byte for byte.
    """
    start = max(0, len(text) - _LENGTH)
    found = _END.search(text, start)
    if found is None and _REWRITTEN.search(text, start):
        raise ValueError("its checksum isn't as it was written: something has formatted it anew")
    if found is None:
        return text
    body = text[: found.start()]
    if found[1] != _sum(body):
        raise ValueError("its checksum says that something in it has changed")
    return body + b"}"


def _sum(body: bytes) -> bytes:
    """The first 16 hex digits of its SHA-256."""
    return hashlib.sha256(body).hexdigest()[:16].encode()
