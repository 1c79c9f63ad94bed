"""What a model keeps of a text that it reads on, and of several side by side."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from typing import Any

from probe.train.tune import libraries

_SPARE = 256
"""Tokens for which room is made at once: each time all that is kept is copied."""


def empty() -> Any:
    """A cache for a text, of which nothing was read yet."""
    return _cache(layer_class_to_replicate=_growing())


def side_by_side(caches: Sequence[Any]) -> Any:
    """A cache for one more token of each of several texts, whose keys and values are tuples.

    Args:
        caches: Of texts that were read, of one model.
    """
    beside = _beside()
    return _cache(
        layers=[beside(layers) for layers in zip(*(it.layers for it in caches), strict=True)]
    )


def _cache(**layers: Any) -> Any:
    return libraries.part("transformers.cache_utils").Cache(**layers)


@lru_cache(1)
def _growing() -> Any:
    base: Any = libraries.part("transformers.cache_utils").DynamicLayer

    class GrowingLayer(base):
        """Has room for some more tokens, while DynamicLayer copies all it has for each."""

        _room: tuple[Any, Any] | None = None

        def update(self, key_states: Any, value_states: Any, *_: Any, **__: Any) -> tuple[Any, Any]:
            read = self.get_seq_length()
            if not self.is_initialized:
                self.lazy_initialization(key_states, value_states)
            end = read + key_states.shape[-2]
            if self._room is None or self._room[0].shape[-2] < end:
                self._room = (
                    _wider(key_states, self.keys, read, end + _SPARE),
                    _wider(value_states, self.values, read, end + _SPARE),
                )
            for room, state in zip(self._room, (key_states, value_states), strict=True):
                room[..., read:end, :] = state
            self.keys, self.values = (room[..., :end, :] for room in self._room)
            return self.keys, self.values

        def crop(self, tokens_to_remove: int) -> None:
            """Forget the last tokens, and the room that they took."""
            super().crop(tokens_to_remove)
            if self.is_initialized:
                self.keys, self.values, self._room = self.keys.clone(), self.values.clone(), None

    return GrowingLayer


def _wider(state: Any, kept: Any, read: int, tokens: int) -> Any:
    room = state.new_empty((*state.shape[:-2], tokens, state.shape[-1]))
    if read:
        room[..., :read, :] = kept
    return room


@lru_cache(1)
def _beside() -> Any:
    base: Any = libraries.part("transformers.cache_utils").CacheLayerMixin

    class BesideLayer(base):
        """A layer of several texts' caches."""

        def __init__(self, layers: Sequence[Any]) -> None:
            super().__init__()
            self._layers = layers

        def lazy_initialization(self, key_states: Any, value_states: Any) -> None:
            """Each has its own."""

        def update(self, key_states: Any, value_states: Any, *_: Any, **__: Any) -> tuple[Any, Any]:
            states = zip(self._layers, key_states.split(1), value_states.split(1), strict=True)
            keys, values = zip(*(layer.update(k, v) for layer, k, v in states), strict=True)
            return keys, values

        def get_mask_sizes(self, query_length: int) -> tuple[int, int]:
            return self.get_seq_length() + query_length, 0

        def get_seq_length(self) -> int:
            return max(layer.get_seq_length() for layer in self._layers)

        def get_max_length(self) -> int:
            return -1

    return BesideLayer
