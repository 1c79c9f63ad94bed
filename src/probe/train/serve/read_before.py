"""What a language model has read before, so that a long conversation isn't read again each turn.

Knows tokens and caches as transformers has them, no protocol.
"""

from __future__ import annotations

import copy
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

KEPT = 4
"""Conversations: a few episodes may take turns, and all begin with the same rules and tools."""


@dataclass(frozen=True, eq=False)
class ReadText:
    """Tokens that were read, and what the model keeps of each."""

    tokens: tuple[int, ...]
    cache: Any


class ReadBefore:
    """The conversations that were read last; one user at a time.

    Args:
        fresh: Makes an empty cache.
        most: How many are kept.
    """

    def __init__(self, fresh: Callable[[], Any], most: int = KEPT) -> None:
        self._fresh, self._most = fresh, most
        self._read: list[ReadText] = []

    def begin(self, asked: Sequence[int]) -> Any:
        """A cache with as much of a request as was read before, and nothing else.

        The last token is never in it: the model has to read something to reply.
        """
        wanted = tuple(asked[:-1])
        best = max(self._read, key=lambda it: shared(it.tokens, wanted), default=None)
        length = shared(best.tokens, wanted) if best else 0
        if best is None or not length:
            return self._fresh()
        if length == len(best.tokens):  # the same conversation, gone on
            self._read.remove(best)
            return best.cache
        cache = copy.deepcopy(best.cache)
        cache.crop(length - len(best.tokens))
        return cache

    def keep(self, tokens: Sequence[int], cache: Any) -> None:
        """Remember a cache by the tokens that were read or said; the oldest one is given up.

        Args:
            tokens: All of them; the cache has as many as it says, the last one said isn't in it.
            cache: Of the model.
        """
        held = tuple(tokens[: cache.get_seq_length()])
        self._read = [*self._read, ReadText(held, cache)][-self._most :]


def shared(one: Sequence[int], other: Sequence[int]) -> int:
    """How many tokens two texts have in common at their start."""
    for place, (a, b) in enumerate(zip(one, other, strict=False)):
        if a != b:
            return place
    return min(len(one), len(other))
