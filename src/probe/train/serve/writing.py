"""Writes replies token by token, several side by side: in a step weights are read once for all.

Knows tokens, no protocol.
"""

from __future__ import annotations

from collections.abc import Generator, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import contextmanager
from dataclasses import dataclass, field
from threading import Event, Lock
from typing import Any

from probe.errors import ProbeError
from probe.train.serve.choosing import Chooser
from probe.train.serve.growing import empty, side_by_side
from probe.train.serve.read_before import KEPT, ReadBefore
from probe.train.tune import libraries


class GivenUp(ProbeError):
    """Nobody waits for a reply any more."""

    def __init__(self) -> None:
        super().__init__("Who asked for this reply is gone.")


@dataclass(eq=False)
class _Text:
    """A conversation and as much of its reply as there is.

    Attributes:
        tokens: Of both.
        asked: How many the conversation has.
        most: Tokens that the reply may have.
        chooser: Of the next one.
        given_up: Set once nobody waits for it any more.
        cache: Of all but the last one; None before it is read.
        reply: Its tokens, once all are there.
    """

    tokens: list[int]
    asked: int
    most: int
    chooser: Chooser
    given_up: Event
    cache: Any = None
    reply: Future[list[int]] = field(default_factory=Future[list[int]])


class Writer:
    """Writes on for as many texts as there are.

    One thread does: PyTorch gives each thread that computes worker threads of its own, and these
    would compete for cores.

    Args:
        model: A language model.
        at_once: Most texts of a step; others wait.
        ends: Tokens after which there is none.
    """

    def __init__(self, model: Any, at_once: int, ends: frozenset[int]) -> None:
        self._model, self._at_once, self._ends = model, at_once, ends
        self._before = ReadBefore(empty, KEPT + at_once - 1)
        self._waiting: list[_Text] = []
        self._writing: list[_Text] = []
        self._door = Lock()
        self._pen = ThreadPoolExecutor(1, "writer")

    def write(
        self, asked: list[int], most: int, chooser: Chooser, given_up: Event | None = None
    ) -> list[int]:
        """A reply's tokens, with the one that ends it; blocks until it is written.

        Args:
            asked: Tokens of the conversation.
            most: Tokens that the reply may have.
            chooser: Of each.
            given_up: To be set once nobody waits for it any more.

        Raises:
            GivenUp: Nobody did.
        """
        text = _Text([*asked], len(asked), most, chooser, given_up or Event())
        with self._door:
            self._waiting.append(text)
        self._pen.submit(self._until_written, text)
        return text.reply.result()

    def _until_written(self, text: _Text) -> None:
        with libraries.torch().inference_mode():
            while not text.reply.done():
                self._step()

    def _step(self) -> None:
        """One more token of each text, after one that is new was read."""
        with self._door:
            room = len(self._writing) < self._at_once
            fresh = self._waiting.pop(0) if room and self._waiting else None
            self._writing += [fresh] if fresh else []
            for text in [*self._waiting, *self._writing]:
                if text.given_up.is_set():
                    self._give_up(text)
            self._waiting = [it for it in self._waiting if not it.reply.done()]
        if fresh and not fresh.reply.done():
            with _failing([fresh]):
                self._read(fresh)
        if going_on := [it for it in self._writing if not it.reply.done()]:
            with _failing(going_on):
                self._write_on(going_on)
        self._writing = [it for it in self._writing if not it.reply.done()]

    def _give_up(self, text: _Text) -> None:
        if text.cache is not None:  # who asks again needn't wait until it is read again
            self._before.keep(text.tokens, text.cache)
        text.reply.set_exception(GivenUp())

    def _read(self, text: _Text) -> None:
        """A conversation, as far as it wasn't read before, and the first token of its reply."""
        text.cache = self._before.begin(text.tokens)
        known = text.cache.get_seq_length()
        scores = self._scores([text.tokens[known:]], [range(known, len(text.tokens))], text.cache)
        self._add(text, scores[0])

    def _write_on(self, texts: list[_Text]) -> None:
        cache = texts[0].cache if len(texts) == 1 else side_by_side([it.cache for it in texts])
        last = [it.tokens[-1:] for it in texts]
        scores = self._scores(last, [[len(it.tokens) - 1] for it in texts], cache)
        for text, of_text in zip(texts, scores, strict=True):
            with _failing([text]):
                self._add(text, of_text)

    def _scores(self, tokens: Any, places: Any, cache: Any) -> Any:
        """Of what follows each text's last token: (texts, vocabulary)."""
        torch, device = libraries.torch(), self._model.device
        return self._model(
            torch.tensor(tokens, device=device),
            position_ids=torch.tensor([list(each) for each in places], device=device),
            past_key_values=cache,
            use_cache=True,
            logits_to_keep=1,
        ).logits[:, -1]

    def _add(self, text: _Text, scores: Any) -> None:
        text.tokens.append(text.chooser.choose(text.tokens, scores))
        said = text.tokens[text.asked :]
        if said[-1] in self._ends or len(said) >= text.most:
            self._before.keep(text.tokens, text.cache)
            text.reply.set_result(said)


@contextmanager
def _failing(texts: Sequence[_Text]) -> Generator[None]:
    """Tell an error to those who wait for these texts, and go on with the others."""
    try:
        yield
    except BaseException as error:
        for text in texts:
            if not text.reply.done():
                text.reply.set_exception(error)
