"""The model that acts in one episode: asks it, has its replies and what went wrong counted."""

from __future__ import annotations

from collections.abc import Sequence

from inspect_ai.log import transcript
from inspect_ai.model import (
    CachePolicy,
    ChatMessage,
    ChatMessageAssistant,
    ChatMessageUser,
    Model,
    ModelOutput,
)
from inspect_ai.tool import ToolInfo
from inspect_ai.util import LimitExceededError

from probe.bench.kept_replies import generated
from probe.bench.prices import Price
from probe.bench.raw_arguments import as_sent
from probe.bench.reasons import said
from probe.bench.usage import EpisodeUsage
from probe.episodes.participation import ModelReply, Participation, Points
from probe.errors import ModelFailed
from probe.texts import writable


class ModelConversation:
    """A conversation with a model.

    Args:
        model: Who is asked.
        tools: What it may call.
        opening: The first messages.
        cache: Where replies are kept, so that an episode that is begun again pays for none twice.
        price: Of its tokens.
        episode_usage: Of the episode.
    """

    def __init__(
        self,
        model: Model,
        tools: Sequence[ToolInfo],
        opening: Sequence[ChatMessage],
        cache: CachePolicy,
        price: Price | None,
        episode_usage: EpisodeUsage,
    ) -> None:
        self.messages = list(opening)
        self.replies: list[ModelReply] = []
        self.output: ModelOutput | None = None
        self._model, self._tools, self._cache = as_sent(model), list(tools), cache
        self._price, self._episode_usage = price, episode_usage
        self._asked = 0

    async def reply(self) -> ChatMessageAssistant:
        """What the model says next; it is added to the messages.

        Raises:
            ModelFailed: No reply came, however often it was tried.
        """
        self._asked += 1
        seen = len(transcript().events)
        try:
            output = await generated(self._model, self.messages, self._cache, self._tools)
        except LimitExceededError:
            raise
        except Exception as error:  # whatever a provider's client may raise
            self._episode_usage.note_retries(self._which, seen)
            reason = said(error)
            self._fault(f"none, {reason}")
            name = self._model.name
            raise ModelFailed(f"{name} gave no reply {self._asked}: {reason}") from error
        self._episode_usage.note_retries(self._which, seen)
        if output.empty:
            self._fault("none, the server sent no choice")
            raise ModelFailed(f"{self._model.name} gave no reply {self._asked}: no choice in it")
        self._count(output)
        return output.message

    @property
    def unheard(self) -> bool:
        """Whether it was asked and has never said anything."""
        return self._asked > 0 and self.output is None

    def say(self, words: str) -> None:
        """Tell the model something."""
        self.messages.append(ChatMessageUser(content=words))

    def seat(self, setting: str, points: Points, more: Sequence[str] = ()) -> Participation:
        """The model's part in the episode.

        Args:
            setting: How it was allowed to answer.
            points: How it counts places.
            more: What else went wrong.
        """
        counted = self._episode_usage
        inward, outward = counted.tokens or (None, None)
        faults = (*counted.faults, *more)
        return Participation(
            setting, points, tuple(self.replies), inward, outward, counted.cost, faults
        )

    def _count(self, output: ModelOutput) -> None:
        self.output = output
        message = output.message
        if message.tool_calls and isinstance(message.content, str):
            # vLLM leaves the line break before a call in the words; its template puts another.
            message.content = message.content.rstrip("\n")
        self.messages.append(message)
        self._episode_usage.count(self._which, output, self._price)
        if output.error:
            self._fault(f"can't be read: {writable(output.error)}")
        elif not output.message.text.strip() and not output.message.tool_calls:
            self._fault("empty")
        for call in output.message.tool_calls or []:
            if call.parse_error:
                self._fault(f"{call.function} was called with what is no JSON object")

    @property
    def _which(self) -> str:
        return f"reply {self._asked}"

    def _fault(self, what: str) -> None:
        self._episode_usage.fault(self._which, what)
