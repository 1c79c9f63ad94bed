"""Attention of the next token of a text, or of the next of each of several texts.

As Transformers calls PyTorch's kernel, each head reads keys anew that several share, which takes
several times as long on processors (docs/results/log.md, 2026-11-29); and it takes only texts of
one length.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache
from typing import Any

from probe.train.tune import libraries
from probe.train.tune.by_blocks import BY_BLOCKS, OTHERWISE

_LENGTHS = ("dynamic", "longrope")
"""Kinds of RoPE that go by the longest text of a step."""


def attend_to_next(model: Any) -> bool:
    """Have a model attend so where it reads one token of a text, and elsewhere as before.

    Returns:
        Whether it does: not if its layers attend to parts of a text, or it attends by neither
        "sdpa" nor BY_BLOCKS.
    """
    config = model.config.get_text_config()
    before: str = config._attn_implementation
    if before not in ("sdpa", BY_BLOCKS) or not _attends_to_all(config):
        return False
    name = _registered(before)
    model.set_attn_implementation(name)  # some models only warn
    return config._attn_implementation == name


def _attends_to_all(config: Any) -> bool:
    """Whether each layer attends to all that was read, at places that only the text decides."""
    kinds = getattr(config, "layer_types", None) or ["full_attention"]
    parts = (getattr(config, name, None) for name in ("sliding_window", "attention_chunk_size"))
    rope: dict[str, Any] = getattr(config, "rope_parameters", None) or {}
    return (
        {*kinds} == {"full_attention"}
        and all(it is None for it in parts)
        and rope.get("rope_type") not in _LENGTHS
    )


@lru_cache
def _registered(otherwise: str) -> str:
    """The name under which Transformers knows this, and for other tokens another attention."""
    transformers = libraries.transformers()
    name = f"next_token_or_{otherwise}"
    attend = _attention(transformers.AttentionInterface()[otherwise])
    transformers.AttentionInterface.register(name, attend)
    mask = transformers.AttentionMaskInterface()[otherwise]
    transformers.AttentionMaskInterface.register(name, mask)
    return name


def _attention(otherwise: Callable[..., Any]) -> Callable[..., Any]:
    """As Transformers asks; keys and values of several texts are tuples."""

    def attend(
        module: Any, query: Any, key: Any, value: Any, attention_mask: Any, **more: Any
    ) -> tuple[Any, None]:
        plain = all(more.get(name) is None for name in OTHERWISE)
        if attention_mask is not None or query.shape[2] > 1 or not plain:
            return otherwise(module, query, key, value, attention_mask, **more)
        scale = more.get("scaling")
        if not isinstance(key, tuple):
            return _values(query, key, value, scale), None
        each = [_values(query[n : n + 1], key[n], value[n], scale) for n in range(len(query))]
        return libraries.torch().cat(each), None

    return attend


def _values(query: Any, key: Any, value: Any, scale: float | None) -> Any:
    """softmax(q k^T) v of one token: (batch, 1, heads, width)."""
    batch, heads, _, width = query.shape
    groups = batch * key.shape[1]
    q = (query * (width**-0.5 if scale is None else scale)).reshape(groups, -1, width)
    k, v = (it.reshape(groups, -1, it.shape[-1]) for it in (key, value))
    # Scores are turned, not keys: there are many more of these.
    scores = (k @ q.transpose(1, 2)).transpose(1, 2).contiguous()
    return (scores.softmax(-1) @ v).reshape(batch, 1, heads, -1)
