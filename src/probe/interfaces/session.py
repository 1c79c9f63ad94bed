"""One episode for somebody outside, done in a thread of its own. Knows no protocol."""

from __future__ import annotations

import logging
import threading
from collections.abc import Callable
from concurrent.futures import Future, ThreadPoolExecutor
from pathlib import Path

from probe.episodes.episode import Episode
from probe.episodes.files import line_of
from probe.episodes.folder import add_line
from probe.episodes.turns import Call
from probe.toolshed.result import ToolResult
from probe.types import Array

NO_TABLE = "The table couldn't be set, which is not your doing; the server's log says why."

_log = logging.getLogger(__name__)


class Session:
    """A table that one client sits at; its calls are done one after another, as they come.

    Physics and drawing take seconds, so whoever speaks with the client gets futures. The record
    is written when the episode ends, or when the client leaves after at least one call.

    Args:
        open_episode: Sets the table; done first, in the session's thread.
        out: Folder that the record is added to.
    """

    def __init__(self, open_episode: Callable[[], Episode], out: Path) -> None:
        self._out = out
        self._thread = ThreadPoolExecutor(1, "table")
        self._keeping = threading.Lock()
        self._kept = False
        self._failure: Exception | None = None
        self._episode: Episode | None = None
        self._thread.submit(self._open, open_episode)

    def first_picture(self) -> Future[Array]:
        """The table before anything was done: sRGB uint8, shape (h, w, 3)."""
        return self._thread.submit(self._first_picture)

    def call(self, call: Call) -> Future[ToolResult]:
        """Do a call once those before it are done; one that is cancelled by then is left out."""
        return self._thread.submit(self._step, call)

    def leave(self) -> None:
        """The client has gone: write down what has been done, without a call under way."""
        if self._episode is not None and self._episode.record.steps:
            self._keep(self._episode)

    def close(self) -> None:
        """Leave, and wait for a call under way.

        Raises:
            Exception: What kept the table from being set or the record from being written.
        """
        self.leave()
        self._thread.shutdown(cancel_futures=True)
        if self._failure is not None:
            raise self._failure

    def _open(self, open_episode: Callable[[], Episode]) -> None:
        try:
            self._episode = open_episode()
        except Exception as error:  # close() raises it; until then the client gets an answer
            self._fail(error)

    def _first_picture(self) -> Array:
        if self._episode is None or self._episode.record.question.picture is None:
            raise LookupError(NO_TABLE)
        return self._episode.record.question.picture

    def _step(self, call: Call) -> ToolResult:
        if self._episode is None:
            return ToolResult(NO_TABLE, ended=True, status="refused")
        try:
            result = self._episode.step(call).result
        except Exception as error:  # a mistake of ours: the record has to say so, too
            _log.exception("A call failed")
            result = self._episode.fail(error)
        if self._episode.ended:
            self._keep(self._episode)
        return result

    def _keep(self, episode: Episode) -> None:
        """Write the record, once."""
        with self._keeping:
            if self._kept:
                return
            self._kept = True
            try:
                add_line(self._out, line_of(episode.record))
            except Exception as error:  # close() raises it; the client did its part
                self._fail(error)

    def _fail(self, error: Exception) -> None:
        self._failure = error
        _log.error("%s", error)
