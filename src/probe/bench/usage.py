"""What replies in one episode cost, and what went wrong with them; whoever gave them."""

from __future__ import annotations

from inspect_ai.event import ModelEvent
from inspect_ai.log import transcript
from inspect_ai.model import ModelOutput

from probe.bench.prices import Price, cost_of, tokens_in
from probe.bench.reasons import LONGEST, explained
from probe.texts import writable

_ODD_STOPS = {
    "content_filter": "refused by the server's filter",
    "max_tokens": "cut off after the most tokens allowed",
    "model_length": "cut off for want of context",
}


class EpisodeUsage:
    """Tokens, dollars and faults of an episode; of the model that acts and the one that points."""

    def __init__(self) -> None:
        self.tokens: tuple[int, int] | None = None
        self.cost: float | None = None
        self.faults: list[str] = []

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
        if usage is None:
            return
        before = self.tokens or (0, 0)
        self.tokens = before[0] + tokens_in(usage), before[1] + usage.output_tokens
        cost = cost_of(usage, price)
        if cost is not None:
            self.cost = (self.cost or 0.0) + cost

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
