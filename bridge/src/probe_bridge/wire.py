"""Bytes to dictionaries and back: msgpack with nothing in it but plain values."""

from __future__ import annotations

from typing import Any, Dict, cast

import msgpack

from probe_bridge.errors import BridgeError

VERSION = 3
"""Of the protocol. Both ends must have the same."""

MAX_REQUEST = 256 * 1024
"""Bytes of the longest request: some thousand waypoints."""

MAX_REPLY = 64 * 1024 * 1024
"""Bytes of the longest reply: a frame of a large camera."""


def pack(message: Dict[str, Any]) -> bytes:
    """A dictionary of plain values as bytes."""
    return cast(bytes, msgpack.packb(message, use_bin_type=True))


def unpack_request(data: object) -> Dict[str, Any]:
    """What a client sent; no bytes are allowed in it.

    Raises:
        BridgeError: "refused"; it isn't a msgpack table of plain values.
    """
    return _unpack(data, MAX_REQUEST, max_bin=0)


def unpack_reply(data: object) -> Dict[str, Any]:
    """What the bridge sent.

    Raises:
        BridgeError: "refused"; it isn't a msgpack table of plain values.
    """
    return _unpack(data, MAX_REPLY, max_bin=MAX_REPLY)


def _unpack(data: object, limit: int, max_bin: int) -> Dict[str, Any]:
    if not isinstance(data, bytes) or len(data) > limit:
        raise BridgeError("refused", f"A message is not binary, or has over {limit} bytes.")
    try:
        message = cast(
            object,
            msgpack.unpackb(
                data,
                raw=False,
                strict_map_key=True,
                max_str_len=4096,
                max_bin_len=max_bin,
                max_array_len=8192,
                max_map_len=64,
                max_ext_len=0,
            ),
        )
    except (ValueError, TypeError, OverflowError, RecursionError, msgpack.UnpackException) as error:
        raise BridgeError("refused", f"A message can't be read: {error}.") from error
    if not isinstance(message, dict):
        raise BridgeError("refused", "A message is not a table.")
    return cast("Dict[str, Any]", message)
