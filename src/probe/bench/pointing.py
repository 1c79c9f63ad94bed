"""The model that points for perception: asked as the table's process wants it, and counted."""

from __future__ import annotations

from inspect_ai.log import transcript
from inspect_ai.model import CachePolicy, ChatMessageUser, ContentImage, ContentText, Model
from inspect_ai.util import LimitExceededError

from probe.bench.kept_replies import generated
from probe.bench.prices import Price
from probe.bench.raw_arguments import as_sent
from probe.bench.reasons import said
from probe.bench.usage import EpisodeUsage
from probe.bench.wire import data_uri
from probe.runs.worker_messages import NoReply, PointerRequest
from probe.texts import writable


class Pointing:
    """Answers what perception asks in one episode; the same question twice gets the same reply.

    Args:
        model: Who is asked.
        episode_usage: Of the episode.
        cache: Where replies are kept, so that an episode that is begun again pays for none twice.
        price: Of its tokens.
    """

    def __init__(
        self, model: Model, episode_usage: EpisodeUsage, cache: CachePolicy, price: Price | None
    ) -> None:
        self._model, self._episode_usage = as_sent(model), episode_usage
        self._cache, self._price = cache, price
        self._known: dict[PointerRequest, str] = {}

    async def __call__(self, asked: PointerRequest) -> str | NoReply:
        """A reply, whatever it says: one that is empty is the model's own failing."""
        if asked in self._known:
            return self._known[asked]
        which = f"pointing {len(self._known) + 1}"
        seen = len(transcript().events)
        try:
            output = await generated(self._model, [_message(asked)], self._cache)
        except LimitExceededError:
            raise
        except Exception as error:  # whatever a provider's client may raise
            self._episode_usage.note_retries(which, seen)
            reason = said(error)
            self._episode_usage.fault(which, f"none, {reason}")
            return NoReply(f"{self._model.name} gave no reply, {which}: {reason}")
        self._episode_usage.note_retries(which, seen)
        if output.empty:
            self._episode_usage.fault(which, "none, the server sent no choice")
            return NoReply(f"{self._model.name} gave no reply, {which}: no choice in it")
        self._episode_usage.count(which, output, self._price)
        if output.error:
            self._episode_usage.fault(which, f"can't be read: {writable(output.error)}")
        elif not output.completion.strip():
            self._episode_usage.fault(which, "empty")
        self._known[asked] = output.completion
        return output.completion


def _message(asked: PointerRequest) -> ChatMessageUser:
    pictures = [ContentImage(image=data_uri(picture)) for picture in asked.pictures]
    return ChatMessageUser(content=[*pictures, ContentText(text=asked.text)])
