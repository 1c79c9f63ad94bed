"""Causal attention in bfloat16 on processors: block by block, by matrix products.

PyTorch's own kernel computes bfloat16 no faster than float32 there (docs/results/log.md,
2026-11-29).
"""

from __future__ import annotations

from functools import lru_cache
from typing import Any

from probe.train.tune import libraries

BY_BLOCKS = "by_blocks"
"""Under this name Transformers knows it."""

_ROWS = 256
"""Queries of a block: few enough that its weights stay in a processor's cache."""

OTHERWISE = ("softcap", "s_aux", "position_bias", "cache")
"""What some models ask for, and only other implementations do."""


def attend_by_blocks(model: Any) -> None:
    """Have a model attend so wherever all tokens see those before them and nothing is padded.

    Elsewhere, as in a batch of several, it attends by PyTorch's own kernel. A model that doesn't
    attend by that kernel in all its parts stays as it is.
    """
    transformers = libraries.transformers()
    parts = (it for it in model.modules() if isinstance(it, transformers.PreTrainedModel))
    if {it.config._attn_implementation for it in parts} != {"sdpa"}:
        return
    transformers.AttentionInterface.register(BY_BLOCKS, _attend)
    transformers.AttentionMaskInterface.register(BY_BLOCKS, _mask)
    model.set_attn_implementation(BY_BLOCKS)


def _mask(**asked: Any) -> Any:
    """None where tokens see all that were read before and no later ones, else PyTorch's mask.

    PyTorch's kernel needs a mask where a text goes on; blocks don't.
    """
    read, more = asked["kv_length"], asked["q_length"]
    if more not in (1, read):
        windowed = asked.get("local_size") is not None
        padded = asked.get("attention_mask") is not None
        last = read == asked.get("q_offset", 0) + more
        if last and asked.get("allow_is_causal_skip") and not (windowed or padded):
            return None
        asked["allow_is_causal_skip"] = False  # there None means that the first tokens ask
    return libraries.part("transformers.masking_utils").sdpa_mask(**asked)


def _attend(
    module: Any,
    query: Any,
    key: Any,
    value: Any,
    attention_mask: Any,
    scaling: float | None = None,
    **more: Any,
) -> tuple[Any, None]:
    """As Transformers asks: of (batch, heads, tokens, width), (batch, tokens, heads, width)."""
    causal = more.get("is_causal")
    causal = getattr(module, "is_causal", False) if causal is None else causal
    alike = query.shape[3] == value.shape[3]
    plain = not more.get("dropout") and all(more.get(name) is None for name in OTHERWISE)
    if attention_mask is not None or not (causal and alike and plain):
        sdpa = libraries.part("transformers.integrations.sdpa_attention").sdpa_attention_forward
        if attention_mask is None and causal:
            attention_mask = _gone_on(query.shape[2], key.shape[2])
        return sdpa(module, query, key, value, attention_mask, scaling=scaling, **more)
    kind = value.dtype
    scale = query.shape[-1] ** -0.5 if scaling is None else scaling
    told = _function().apply((query * scale).to(kind), key.to(kind), value)
    return told.transpose(1, 2).contiguous(), None


def _gone_on(tokens: int, of: int) -> Any:
    """The mask of a text's last tokens; None where the kernel needs none."""
    if tokens in (1, of):
        return None
    return libraries.torch().ones(tokens, of, dtype=bool).tril(of - tokens)


@lru_cache(1)
def _function() -> Any:
    """softmax(q k^T) v for PyTorch's autograd."""
    base: Any = libraries.torch().autograd.Function

    class Blocks(base):
        """Weights are computed anew for the gradient, since memory is slower."""

        @staticmethod
        def forward(context: Any, query: Any, key: Any, value: Any) -> Any:
            context.save_for_backward(query, key, value)
            return _values(*_by_key(query, key, value)).view_as(query)

        @staticmethod
        def backward(context: Any, gradient: Any) -> tuple[Any, ...]:
            inputs = context.saved_tensors
            given = gradient.to(inputs[0].dtype)
            found = _gradients(*_by_key(*inputs), given)
            return tuple(it.view_as(of).to(of.dtype) for it, of in zip(found, inputs, strict=True))

    return Blocks


def _values(q: Any, k: Any, v: Any) -> Any:
    """softmax(q k^T) v, as _by_key() has them."""
    out = libraries.torch().empty_like(q)
    for start in range(0, q.shape[2], _ROWS):
        rows, end = _rows(q, start)
        weights = _weights(rows, k, end - start, _seen(q, k, end))
        out[:, :, start:end] = (weights @ v[:, : weights.shape[2]]).view_as(out[:, :, start:end])
    return out


def _gradients(q: Any, k: Any, v: Any, given: Any) -> tuple[Any, Any, Any]:
    """Of q, k and v, given that of the values (Dao et al. 2022, arXiv:2205.14135, algorithm 4)."""
    torch = libraries.torch()
    given = given.reshape(q.shape)
    dq = torch.empty_like(q)
    kind = torch.promote_types(k.dtype, torch.float32)  # many blocks are summed
    dk, dv = torch.zeros_like(k, dtype=kind), torch.zeros_like(v, dtype=kind)
    for start in range(0, q.shape[2], _ROWS):
        rows, end = _rows(q, start)
        out, _ = _rows(given, start)
        seen = _seen(q, k, end)
        weights = _weights(rows, k, end - start, seen)
        dv[:, :seen] += weights.transpose(1, 2) @ out
        to_weights = out @ v[:, :seen].transpose(1, 2)
        # weights * (to_weights - the sum of weights * to_weights along a row)
        to_scores = torch.ops.aten._softmax_backward_data(to_weights, weights, -1, weights.dtype)
        dq[:, :, start:end] = (to_scores @ k[:, :seen]).view_as(dq[:, :, start:end])
        dk[:, :seen] += to_scores.transpose(1, 2) @ rows
    return dq, dk, dv


def _by_key(query: Any, key: Any, value: Any) -> tuple[Any, Any, Any]:
    """Queries beside the keys that several heads share: (keys' heads, of each, tokens, width)."""
    batch, heads, tokens, width = query.shape
    groups = batch * key.shape[1]
    q = query.reshape(groups, heads // key.shape[1], tokens, width)
    return q, key.reshape(groups, -1, key.shape[3]), value.reshape(groups, -1, value.shape[3])


def _rows(of: Any, start: int) -> tuple[Any, int]:
    """A block's tokens of all heads beneath each other, and where it ends."""
    end = min(start + _ROWS, of.shape[2])
    return of[:, :, start:end].reshape(of.shape[0], -1, of.shape[3]), end


def _seen(q: Any, k: Any, end: int) -> int:
    """Tokens up to a block's end, with those that were read before the queries."""
    return k.shape[1] - q.shape[2] + end


def _weights(rows: Any, k: Any, tokens: int, seen: int) -> Any:
    """How much each token of a block attends to each up to its end."""
    torch = libraries.torch()
    scores = rows @ k[:, :seen].transpose(1, 2)
    later = torch.full((tokens, tokens), float("-inf"), dtype=scores.dtype).triu(1)
    scores.view(k.shape[0], -1, tokens, seen)[..., seen - tokens :] += later
    return torch.softmax(scores, -1)
