"""A trained model that replies to conversations. Knows no protocol but the form of messages."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from threading import Event, Lock
from typing import Any

from jinja2 import TemplateError

from probe.errors import BadData, ProbeError
from probe.train.serve.choosing import Chooser, check_recommended
from probe.train.serve.constraining import CallForms
from probe.train.serve.next_token import attend_to_next
from probe.train.serve.replying import ServedReply, read_reply
from probe.train.serve.writing import Writer
from probe.train.tune import libraries
from probe.train.tune.by_blocks import attend_by_blocks
from probe.train.tune.collating import encoded
from probe.train.tune.conversations import NotUnderstood, of_request
from probe.train.tune.loading import load
from probe.train.tune.processors import sees, tokenizer_of

MOST_TOKENS = 512
"""Of a reply, if a request doesn't say."""

MOST_TEMPERATURE = 2
"""As in OpenAI's protocol."""


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
    """A model in memory.

    A language model doesn't read again what it has read before, and may write several replies at
    once. One that sees does neither: its tokens don't say which pictures they stand for.

    Args:
        model: Its folder, or a name at Hugging Face.
        cpu_bfloat16: Without a GPU, compute in bfloat16 if the processor has instructions for it.
        most_tokens: Of a reply, if a request doesn't say.
        constrained: A reply to a request with tools is a call that fits the schema of one, whatever
            the model would rather say.
        temperature: Where a request says none; at 0 the likeliest words.
        seed: Of what is drawn at a temperature; the order of requests matters, too.
        at_once: Replies that are written side by side, at most.

    Raises:
        BadData: This model can't write several at once.
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
        at_once: int = 1,
    ) -> None:
        torch = libraries.torch()
        torch.manual_seed(seed)
        self._temperature = temperature
        loaded, self._processor = load(model, cpu_bfloat16=cpu_bfloat16)
        self._model = loaded.to("cuda" if torch.cuda.is_available() else "cpu").eval()
        ends: Any = self._model.generation_config.eos_token_id
        listed: list[int] = [ends] if isinstance(ends, int) else ends or []
        self._ends = frozenset([*listed, int(tokenizer_of(self._processor).eos_token_id)])
        self._writer = None if sees(self._processor) else self._writer_of(model, at_once)
        if self._writer is None and at_once > 1:
            raise _one_at_a_time(model, "it sees")
        self._forms = CallForms(tokenizer_of(self._processor)) if constrained else None
        self._most_tokens = most_tokens
        self._lock = Lock()

    def asked(self, body: Mapping[str, Any]) -> Any:
        """Tokens and pictures that a request gives the model.

        Raises:
            NotUnderstood: It isn't in OpenAI's form.
        """
        tools: Sequence[Mapping[str, Any]] | None = body.get("tools") or None
        conversation = of_request(body["messages"])
        try:
            return encoded(self._processor, conversation, tools, asking=True)
        except (TemplateError, TypeError) as error:
            raise NotUnderstood(f"the model's template can't write it ({error})") from error

    def reply(self, body: Mapping[str, Any], given_up: Event | None = None) -> GeneratedReply:
        """Reply to a request.

        Args:
            body: In OpenAI's form.
            given_up: To be set once nobody waits for the reply any more; a model that sees pays no
                heed to it.

        Raises:
            GivenUp: It was.
            NotUnderstood: It isn't in OpenAI's form.
            ConversationTooLong: No room is left for a reply.
        """
        asked = self.asked(body).to(self._model.device)
        start = asked["input_ids"].shape[1]
        most = self._room(start, _limit(body, self._most_tokens))
        warmth = _temperature(body, self._temperature)
        tools = body.get("tools") if self._forms else None
        kept_to = self._forms.keep_to(tools) if self._forms and tools else None
        if self._writer is None:
            fresh = self._generated(asked, most, warmth, kept_to)
        else:
            chooser = Chooser(self._model.generation_config, warmth, kept_to)
            fresh = self._writer.write(asked["input_ids"][0].tolist(), most, chooser, given_up)
        tokenizer = tokenizer_of(self._processor)
        ended = bool(fresh) and fresh[-1] in self._ends
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

    def _generated(self, asked: Any, most: int, warmth: float, kept_to: Any) -> list[int]:
        """A reply's tokens of a model that sees."""
        how: dict[str, Any] = {"max_new_tokens": most, "do_sample": warmth > 0}
        how["eos_token_id"] = sorted(self._ends)
        if warmth > 0:
            how["temperature"] = warmth
        if kept_to:
            how["logits_processor"] = [kept_to]
        with self._lock, libraries.torch().inference_mode():
            made = self._model.generate(**asked, **how)[0]
        return made[asked["input_ids"].shape[1] :].tolist()

    def _writer_of(self, model: str, at_once: int) -> Writer:
        """What writes a language model's replies."""
        torch = libraries.torch()
        if self._model.dtype == torch.bfloat16 and self._model.device.type == "cpu":
            attend_by_blocks(self._model)
        if not attend_to_next(self._model) and at_once > 1:
            raise _one_at_a_time(model, "it doesn't attend by PyTorch's kernel to all it has read")
        check_recommended(model, self._model.generation_config)
        return Writer(self._model, at_once, self._ends)


def _limit(body: Mapping[str, Any], usual: int) -> int:
    """Tokens of a reply that a request wants at most."""
    limits = [body.get("max_completion_tokens"), body.get("max_tokens")]
    asked = next((it for it in limits if it is not None), usual)
    if not isinstance(asked, int) or asked < 1:
        raise NotUnderstood(f"a reply can't have {asked!r} tokens at most")
    return asked


def _temperature(body: Mapping[str, Any], usual: float) -> float:
    asked = body.get("temperature")
    if asked is None:
        return usual
    if not isinstance(asked, (int, float)) or not 0 <= asked <= MOST_TEMPERATURE:
        raise NotUnderstood(f"{asked!r} is no temperature from 0 to {MOST_TEMPERATURE}")
    return float(asked)


def _one_at_a_time(model: str, reason: str) -> BadData:
    return BadData("--at-once", f"{model} can write one reply at a time, since {reason}", "Say 1")
