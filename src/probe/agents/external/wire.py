"""Lines over a socket, with an end of patience and of length. Knows nothing of what they say."""

from __future__ import annotations

import socket
import time

_PIECE = 65_536


class WireCut(Exception):
    """The other side is gone."""


class TooLate(Exception):
    """Nothing whole came, or went, in time."""


class TooLong(Exception):
    """A line goes on beyond its bound."""


class Wire:
    """Sends and receives whole lines.

    A connection of `multiprocessing` would wait for ever for the rest of a message that was begun.

    Args:
        end: Our end of a stream socket.
    """

    def __init__(self, end: socket.socket) -> None:
        self._end = end
        self._rest = b""

    def close(self) -> None:
        """Hang up."""
        self._end.close()

    def send(self, line: bytes, seconds: float | None = None) -> None:
        """Send a line, its end included.

        Raises:
            WireCut, TooLate
        """
        self._end.settimeout(seconds)
        try:
            self._end.sendall(line)
        except TimeoutError as error:
            raise TooLate from error
        except OSError as error:
            raise WireCut from error

    def receive(self, longest: int | None = None, seconds: float | None = None) -> bytes:
        """The next line, without its end.

        Args:
            longest: Bytes that it may have; None for any number.
            seconds: How long to wait for the whole of it; None for ever.

        Raises:
            WireCut, TooLate, TooLong
        """
        until = None if seconds is None else time.monotonic() + seconds
        while b"\n" not in self._rest:
            if longest is not None and len(self._rest) > longest:
                raise TooLong
            self._rest += self._piece(until)
        line, _, self._rest = self._rest.partition(b"\n")
        if longest is not None and len(line) > longest:
            raise TooLong
        return line

    def _piece(self, until: float | None) -> bytes:
        left = None if until is None else until - time.monotonic()
        if left is not None and left <= 0:
            raise TooLate
        self._end.settimeout(left)
        try:
            piece = self._end.recv(_PIECE)
        except TimeoutError as error:
            raise TooLate from error
        except OSError as error:
            raise WireCut from error
        if not piece:
            raise WireCut
        return piece
