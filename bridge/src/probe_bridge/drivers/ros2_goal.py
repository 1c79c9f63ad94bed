"""One goal of a ROS 2 action: sent, perhaps accepted, ended, or cancelled at any time between."""

from __future__ import annotations

import threading
from typing import Any

_SUCCEEDED = 4
"""action_msgs/GoalStatus.STATUS_SUCCEEDED."""


class Goal:
    """Follows a goal from future to future. Its methods may be called from any thread.

    Args:
        what: Moves; for errors.
        may_stall: Whether a goal that ends because something holds it back has succeeded.
    """

    def __init__(self, what: str, may_stall: bool = False) -> None:
        self._what = what
        self._may_stall = may_stall
        self._lock = threading.Lock()
        self._handle: Any = None
        self._cancelled = False
        self._ended = False
        self._failure = ""

    def follow(self, sent: Any) -> None:
        """Take over the future of ActionClient.send_goal_async."""
        sent.add_done_callback(self._answered)

    def ended(self) -> bool:
        """Whether it has ended well; raises RuntimeError if it ended otherwise."""
        if self._failure:
            raise RuntimeError(self._failure)
        return self._ended

    def cancel(self) -> None:
        """Cancel it now, or as soon as it is accepted."""
        with self._lock:
            self._cancelled = True
            if self._handle and not self._ended:
                self._handle.cancel_goal_async()

    def _answered(self, future: Any) -> None:
        handle = future.result()
        if not handle.accepted:
            self._failure = f"{self._what}'s controller rejects the goal"
            return
        with self._lock:
            self._handle = handle
            if self._cancelled:
                handle.cancel_goal_async()
        handle.get_result_async().add_done_callback(self._finished)

    def _finished(self, future: Any) -> None:
        reply = future.result()
        stalled = self._may_stall and bool(getattr(reply.result, "stalled", False))
        if reply.status != _SUCCEEDED and not stalled:
            reason = getattr(reply.result, "error_string", "")
            self._failure = f"{self._what}'s goal ended with status {reply.status} {reason}".strip()
        self._ended = True
