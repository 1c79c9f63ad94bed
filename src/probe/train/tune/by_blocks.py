"""Causal attention for training on processors: block by block, by products of matrices.

PyTorch's own kernel computes bfloat16 no faster than float32 there, on two cores at a quarter of
the speed of its matrix products (docs/results/log.md, 2026-11-29).
"""

from __future__ import annotations

from functools import lru_cache
from typing import Any

from probe.train.tune import libraries

BY_BLOCKS = "by_blocks"
"""Under this name Transformers knows it."""

_ROWS = 256
"""Queries of a block: few enough that its weights stay in a processor's cache."""


def attend_by_blocks(model: Any) -> None:
    """Have a model attend so wherever all tokens see those before them and nothing is padded.

    Elsewhere, as in a batch of several, it attends by PyTorch's own kernel.
    """
    transformers = libraries.transformers()
    masks = libraries.part("transformers.masking_utils")
    transformers.AttentionInterface.register(BY_BLOCKS, _attend)
    transformers.AttentionMaskInterface.register(BY_BLOCKS, masks.sdpa_mask)
    model.set_attn_implementation(BY_BLOCKS)


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
    plain = attention_mask is None and not more.get("dropout") and query.shape[2] == key.shape[2]
    if not plain or not more.get("is_causal", getattr(module, "is_causal", False)):
        sdpa = libraries.part("transformers.integrations.sdpa_attention").sdpa_attention_forward
        return sdpa(module, query, key, value, attention_mask, scaling=scaling, **more)
    kind = value.dtype
    scale = query.shape[-1] ** -0.5 if scaling is None else scaling
    told = _blocks().apply((query * scale).to(kind), key.to(kind), value)
    return told.transpose(1, 2).contiguous(), None


@lru_cache(1)
def _blocks() -> Any:
    """The function with its gradient: weights are computed anew, since memory is slower."""
    torch = libraries.torch()
    base: Any = torch.autograd.Function

    class Blocks(base):
        """softmax(q k^T) v and its gradient (Dao et al. 2022, arXiv:2205.14135, algorithm 4)."""

        @staticmethod
        def forward(context: Any, query: Any, key: Any, value: Any) -> Any:
            context.save_for_backward(query, key, value)
            q, k, v = _by_key(query, key, value)
            out = torch.empty_like(q)
            for start in range(0, q.shape[2], _ROWS):
                rows, end = _rows(q, start)
                weights = _weights(torch, rows, k, start, end)
                out[:, :, start:end] = (weights @ v[:, :end]).view_as(out[:, :, start:end])
            return out.view_as(query)

        @staticmethod
        def backward(context: Any, gradient: Any) -> tuple[Any, Any, Any]:
            query, key, value = context.saved_tensors
            q, k, v = _by_key(query, key, value)
            g = gradient.to(q.dtype).reshape(q.shape)
            dq, dk, dv = torch.empty_like(q), torch.zeros_like(k), torch.zeros_like(v)
            for start in range(0, q.shape[2], _ROWS):
                rows, end = _rows(q, start)
                given, _ = _rows(g, start)
                weights = _weights(torch, rows, k, start, end)
                dv[:, :end] += weights.transpose(1, 2) @ given
                to_weights = given @ v[:, :end].transpose(1, 2)
                # Of the softmax: weights * (given - sum of weights * given along a row).
                to_scores = torch.ops.aten._softmax_backward_data(
                    to_weights, weights, -1, weights.dtype
                )
                dq[:, :, start:end] = (to_scores @ k[:, :end]).view_as(dq[:, :, start:end])
                dk[:, :end] += to_scores.transpose(1, 2) @ rows
            return dq.view_as(query), dk.view_as(key), dv.view_as(value)

    return Blocks


def _by_key(query: Any, key: Any, value: Any) -> tuple[Any, Any, Any]:
    """Queries beside the keys that several heads share: (keys' heads, of each, tokens, width)."""
    batch, heads, tokens, width = query.shape
    groups = batch * key.shape[1]
    q = query.reshape(groups, heads // key.shape[1], tokens, width)
    return q, key.reshape(groups, tokens, -1), value.reshape(groups, tokens, -1)


def _rows(of: Any, start: int) -> tuple[Any, int]:
    """A block's tokens of all heads beneath each other, and where it ends."""
    end = min(start + _ROWS, of.shape[2])
    return of[:, :, start:end].reshape(of.shape[0], -1, of.shape[3]), end


def _weights(torch: Any, rows: Any, k: Any, start: int, end: int) -> Any:
    """How much each token of a block attends to each up to its end."""
    scores = rows @ k[:, :end].transpose(1, 2)
    later = torch.full((end - start, end - start), float("-inf"), dtype=scores.dtype).triu(1)
    scores.view(k.shape[0], -1, end - start, end)[..., start:] += later
    return torch.softmax(scores, -1)
