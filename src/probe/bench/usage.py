"""What replies in one episode cost, and what went wrong with them; whoever gave them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TypeVar

from inspect_ai.event import ModelEvent
from inspect_ai.log import transcript
from inspect_ai.model import ModelOutput

from probe.bench.prices import Price, cost_of, tokens_in
from probe.bench.reasons import LONGEST, explained
from probe.texts import writable

_Count = TypeVar("_Count", int, float)

_ODD_STOPS = {
    "content_filter": "refused by the server's filter",
    "max_tokens": "cut off after the most tokens allowed",
    "model_length": "cut off for want of context",
}
_NOT_TAKEN = ("content_filter", "model_length")
"""With these, and without a count of tokens, the harness tells of a request that was refused."""


class EpisodeUsage:
    """Tokens, dollars and faults of an episode; of the model that acts and the one that points."""

    def __init__(self) -> None:
        self.faults: list[str] = []
        self._inward: list[int | None] = []
        self._outward: list[int | None] = []
        self._costs: list[float | None] = []

    @property
    def tokens(self) -> tuple[int, int] | None:
        """Of all requests and of all replies; None where a server didn't say."""
        inward, outward = _total(self._inward), _total(self._outward)
        return None if inward is None or outward is None else (inward, outward)

    @property
    def cost(self) -> float | None:
        """US dollars for all replies; None where one has no price, or its tokens aren't known."""
        return _total(self._costs)

    def count(self, which: str, output: ModelOutput, price: Price | None) -> None:
        """Take in a reply.

        Args:
            which: "reply 3", say.
            output: The reply.
            price: Of its tokens.
        """
        if output.stop_reason in _ODD_STOPS:
            self.fault(which, _ODD_STOPS[output.stop_reason])
        usage = output.usage
        if usage is None and output.stop_reason in _NOT_TAKEN:
            return
        self._inward.append(tokens_in(usage) if usage else None)
        self._outward.append(usage.output_tokens if usage else None)
        self._costs.append(cost_of(usage, price) if usage else None)

    def note_retries(self, which: str, seen: int) -> None:
        """What is tried again below us is in the harness's own log alone.

        A provider's client tries again within an attempt of the harness, which tries again itself.

        Args:
            which: Of the replies.
            seen: How many events that log had before it was asked for.
        """
        events = [each for each in transcript().events[seen:] if isinstance(each, ModelEvent)]
        reasons = [each.error for each in events if each.error]
        failed = len(reasons) + sum(each.retries or 0 for each in events)
        if failed:
            times = "once" if failed == 1 else f"{failed} times"
            why = ""
            if reasons:
                why = f": {explained(writable(' '.join(reasons[-1].split())[:LONGEST]))}"
            self.fault(which, f"the server failed {times}{why}")

    def fault(self, which: str, what: str) -> None:
        """Note what went wrong with a reply."""
        self.faults.append(f"{which}: {what}")


def _total(counts: Sequence[_Count | None]) -> _Count | None:
    """Their sum; None if there are none, or one isn't known."""
    known = [count for count in counts if count is not None]
    return sum(known[1:], known[0]) if known and len(known) == len(counts) else None
