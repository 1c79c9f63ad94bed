"""A trained model that replies to conversations. Knows no protocol but the form of messages."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from threading import Lock
from typing import Any

from probe.errors import ProbeError
from probe.train.serve.constraining import CallForms
from probe.train.serve.read_before import ReadBefore
from probe.train.serve.replying import ServedReply, read_reply
from probe.train.tune import libraries
from probe.train.tune.collating import encoded
from probe.train.tune.conversations import of_request
from probe.train.tune.loading import load
from probe.train.tune.processors import sees, tokenizer_of

MOST_TOKENS = 512
"""Of a reply, if a request doesn't say."""


class ConversationTooLong(ProbeError):
    """More tokens than a model can read leave it no room for a reply."""

    def __init__(self, tokens: int, window: int) -> None:
        super().__init__(
            f"The conversation has {tokens} tokens, and this model's maximum context length is "
            f"{window}. Tell it less (--graphs short), or take a model that reads more."
        )


@dataclass(frozen=True)
class GeneratedReply:
    """A reply and what it took.

    Attributes:
        reply: In words and calls.
        tokens_in, tokens_out: Of the request and of the reply.
        cut: The reply was cut off.
    """

    reply: ServedReply
    tokens_in: int
    tokens_out: int
    cut: bool


class ServedModel:
    """A model in memory; one reply at a time.

    A language model doesn't read again what it has read before. One that sees does: its tokens
    don't say which pictures they stand for.

    Args:
        model: Its folder, or a name at Hugging Face.
        cpu_bfloat16: Without a GPU, compute in bfloat16 if the processor has instructions for it.
        most_tokens: Of a reply, if a request doesn't say.
        constrained: A reply to a request with tools is a call that fits the schema of one, whatever
            the model would rather say.
        temperature: Where a request says none; at 0 the likeliest words.
        seed: Of what is drawn at a temperature; the order of requests matters, too.

    Raises:
        MissingExtra: A library isn't installed.
        NoModel: It can't be loaded.
    """

    def __init__(
        self,
        model: str,
        *,
        cpu_bfloat16: bool = False,
        most_tokens: int = MOST_TOKENS,
        constrained: bool = False,
        temperature: float = 0.0,
        seed: int = 0,
    ) -> None:
        torch = libraries.torch()
        torch.manual_seed(seed)
        self._temperature = temperature
        loaded, self._processor = load(model, cpu_bfloat16=cpu_bfloat16)
        self._model = loaded.to("cuda" if torch.cuda.is_available() else "cpu").eval()
        fresh = libraries.transformers().DynamicCache
        self._before = None if sees(self._processor) else ReadBefore(fresh)
        self._forms = CallForms(tokenizer_of(self._processor)) if constrained else None
        self._most_tokens = most_tokens
        self._lock = Lock()

    def asked(self, body: Mapping[str, Any]) -> Any:
        """Tokens and pictures that a request gives the model.

        Raises:
            NotUnderstood: It isn't in OpenAI's form.
        """
        tools: Sequence[Mapping[str, Any]] | None = body.get("tools") or None
        return encoded(self._processor, of_request(body["messages"]), tools, asking=True)

    def reply(self, body: Mapping[str, Any]) -> GeneratedReply:
        """Reply to a request.

        Raises:
            NotUnderstood: It isn't in OpenAI's form.
            ConversationTooLong: No room is left for a reply.
        """
        asked = self.asked(body).to(self._model.device)
        start = asked["input_ids"].shape[1]
        most = int(body.get("max_completion_tokens") or body.get("max_tokens") or 0)
        most = self._room(start, most or self._most_tokens)
        said = body.get("temperature")
        warmth = self._temperature if said is None else float(said)
        how: dict[str, Any] = {"do_sample": warmth > 0}
        if warmth > 0:
            how["temperature"] = warmth
        if self._forms and (tools := body.get("tools")):
            how["logits_processor"] = [self._forms.keep_to(tools)]
        with self._lock, libraries.torch().inference_mode():
            made = self._made(asked, {"max_new_tokens": most, **how})
        fresh = made[start:]
        tokenizer = tokenizer_of(self._processor)
        ended = tokenizer.eos_token_id in fresh.tolist()
        # Tags of calls are no special tokens of Qwen's tokenizer, and stay.
        text = tokenizer.decode(fresh, skip_special_tokens=True)
        return GeneratedReply(read_reply(text), start, len(fresh), cut=not ended)

    def _room(self, start: int, most: int) -> int:
        """Tokens that a reply may have after so many others."""
        config = self._model.config.get_text_config()
        window: int | None = getattr(config, "max_position_embeddings", None)
        if window is None:
            return most
        if start >= window:
            raise ConversationTooLong(start, window)
        return min(most, window - start)

    def _made(self, asked: Any, how: dict[str, Any]) -> Any:
        """All tokens, those that were asked and those of the reply."""
        if self._before is None:
            return self._model.generate(**asked, **how)[0]
        cache = self._before.begin(asked["input_ids"][0].tolist())
        made = self._model.generate(**asked, **how, past_key_values=cache)[0]
        self._before.keep(made.tolist(), cache)
        return made
