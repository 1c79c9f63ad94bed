"""One model in one episode: asks it, counts what it said and cost, notes what went wrong."""

from __future__ import annotations

from collections.abc import Sequence

from inspect_ai.event import ModelEvent
from inspect_ai.log import transcript
from inspect_ai.model import (
    CachePolicy,
    ChatMessage,
    ChatMessageAssistant,
    ChatMessageUser,
    GenerateConfig,
    Model,
    ModelOutput,
)
from inspect_ai.tool import ToolInfo
from inspect_ai.util import LimitExceededError

from probe.bench.as_sent import as_sent
from probe.bench.prices import Price, cost_of, tokens_in
from probe.episodes.seat import Points, Reply, Seat
from probe.errors import ModelFailed

_LONGEST = 200
"""Characters of what a server says that a record keeps."""

_ODD_STOPS = {
    "content_filter": "refused by the server's filter",
    "max_tokens": "cut off after the most tokens allowed",
    "model_length": "cut off for want of context",
}


class Listener:
    """A conversation with a model.

    Args:
        model: Who is asked.
        tools: What it may call.
        opening: The first messages.
        cache: Where replies are kept, so that an episode that is begun anew pays for none twice.
        price: Of its tokens.
    """

    def __init__(
        self,
        model: Model,
        tools: Sequence[ToolInfo],
        opening: Sequence[ChatMessage],
        cache: CachePolicy,
        price: Price | None,
    ) -> None:
        self.messages = list(opening)
        self.replies: list[Reply] = []
        self.faults: list[str] = []
        self.output: ModelOutput | None = None
        self._model, self._tools, self._cache = as_sent(model), list(tools), cache
        self._price = price
        self._asked = 0
        self._tokens: tuple[int, int] | None = None
        self._cost: float | None = None

    async def reply(self) -> ChatMessageAssistant:
        """What the model says next; it is added to the messages.

        Raises:
            ModelFailed: No reply came, however often it was tried.
        """
        self._asked += 1
        seen = len(transcript().events)
        try:
            output = await self._model.generate(
                self.messages,
                tools=self._tools,
                config=GenerateConfig(parallel_tool_calls=False)
                if self._tools
                else GenerateConfig(),
                cache=self._cache,
            )
        except LimitExceededError:
            raise
        except Exception as error:  # whatever a provider's client may raise
            self._note_retries(seen)
            reason = f"{type(error).__name__}: {_said(error)}"
            self._fault(f"none, {reason}")
            name = self._model.name
            raise ModelFailed(f"{name} gave no reply {self._asked}: {reason}") from error
        self._note_retries(seen)
        self._count(output)
        return output.message

    def say(self, words: str) -> None:
        """Tell the model something."""
        self.messages.append(ChatMessageUser(content=words))

    def seat(self, arm: str, points: Points, more: Sequence[str] = ()) -> Seat:
        """The model's part in the episode.

        Args:
            arm: How it was allowed to answer.
            points: How it counts places.
            more: What else went wrong.
        """
        inward, outward = self._tokens or (None, None)
        faults = (*self.faults, *more)
        return Seat(arm, points, tuple(self.replies), inward, outward, self._cost, faults)

    def _count(self, output: ModelOutput) -> None:
        self.output = output
        self.messages.append(output.message)
        if output.stop_reason in _ODD_STOPS:
            self._fault(_ODD_STOPS[output.stop_reason])
        if not output.message.text.strip() and not output.message.tool_calls:
            self._fault("empty")
        for call in output.message.tool_calls or []:
            if call.parse_error:
                self._fault(f"{call.function} was called with what is no JSON object")
        usage = output.usage
        if usage is None:
            return
        before = self._tokens or (0, 0)
        self._tokens = before[0] + tokens_in(usage), before[1] + usage.output_tokens
        cost = cost_of(usage, self._price)
        if cost is not None:
            self._cost = (self._cost or 0.0) + cost

    def _note_retries(self, seen: int) -> None:
        """What is tried again below us is in the harness's own log alone.

        A provider's client tries again within an attempt of the harness, which tries again itself.
        """
        events = [each for each in transcript().events[seen:] if isinstance(each, ModelEvent)]
        reasons = [each.error for each in events if each.error]
        failed = len(reasons) + sum(each.retries or 0 for each in events)
        if failed:
            times = "once" if failed == 1 else f"{failed} times"
            why = f": {' '.join(reasons[-1].split())[:_LONGEST]}" if reasons else ""
            self._fault(f"the server failed {times}{why}")

    def _fault(self, what: str) -> None:
        self.faults.append(f"reply {self._asked}: {what}")


def _said(error: Exception) -> str:
    """What a server said; the harness's own words begin with the whole request."""
    words = getattr(error, "provider_message", None) or str(error)
    status = getattr(error, "status_code", None)
    return " ".join(f"{status or ''} {words}".split())[:_LONGEST]
