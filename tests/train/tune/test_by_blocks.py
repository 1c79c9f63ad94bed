"""Attention by blocks gives what attention is defined to be, and its gradient."""

from __future__ import annotations

import math
from types import SimpleNamespace

import pytest

from probe.train.tune import libraries
from probe.train.tune.by_blocks import attend_by_blocks

pytestmark = pytest.mark.slow  # PyTorch

TOLERANCE = {"float64": 1e-9, "bfloat16": 0.02}


def defined(query, key, value):
    """softmax(q k^T / sqrt(width)) v over no later token; a key's head has several of queries."""
    torch = libraries.torch()
    key, value = (it.repeat_interleave(query.shape[1] // it.shape[1], 1) for it in (key, value))
    scores = torch.einsum("bhqd,bhkd->bhqk", query, key) / math.sqrt(query.shape[-1])
    tokens = torch.arange(query.shape[2])
    scores = scores.masked_fill(tokens[None, :] > tokens[:, None], float("-inf"))
    return torch.einsum("bhqk,bhkd->bqhd", scores.exp() / scores.exp().sum(-1, keepdim=True), value)


def by_blocks(query, key, value):
    attention = libraries.part("transformers").AttentionInterface()["by_blocks"]
    module = SimpleNamespace(is_causal=True, num_key_value_groups=query.shape[1] // key.shape[1])
    return attention(module, query, key, value, None)[0]


def with_gradients(attend, inputs, kind):
    torch = libraries.torch()
    leaves = [it.to(kind).requires_grad_() for it in inputs]
    made = attend(*leaves)
    weights = torch.linspace(-1, 1, made.numel(), dtype=torch.float64).view(made.shape)
    (made.double() * weights).sum().backward()
    return [made, *(it.grad for it in leaves)]


@pytest.fixture(scope="module", autouse=True)
def registered():
    attend_by_blocks(SimpleNamespace(set_attn_implementation=lambda name: None))


@pytest.mark.parametrize("kind", ["float64", "bfloat16"])
@pytest.mark.parametrize(
    ("batch", "heads", "of_keys", "tokens"),
    [(1, 9, 3, 700), (2, 4, 4, 256), (1, 6, 2, 257), (1, 3, 1, 5)],
)
def test_values_and_gradients(kind, batch, heads, of_keys, tokens):
    torch = libraries.torch()
    torch.manual_seed(tokens)
    inputs = [torch.randn(batch, n, tokens, 16) for n in (heads, of_keys, of_keys)]
    found = with_gradients(by_blocks, inputs, getattr(torch, kind))
    wanted = with_gradients(defined, inputs, torch.float64)
    for mine, other in zip(found, wanted, strict=True):
        assert mine.shape == other.shape
        assert (mine.double() - other).norm() < TOLERANCE[kind] * other.norm()


def test_what_is_padded_is_left_to_the_kernel():
    torch = libraries.torch()
    torch.manual_seed(0)
    query, key, value = (torch.randn(2, 3, 40, 16) for _ in range(3))
    allowed = torch.ones(40, 40, dtype=torch.bool).tril().repeat(2, 1, 1, 1)
    allowed[1, ..., 5] = False  # nobody but itself sees a filler
    allowed[1, :, 5, 5] = True
    attention = libraries.part("transformers").AttentionInterface()["by_blocks"]
    module = SimpleNamespace(is_causal=True, num_key_value_groups=1)
    found = attention(module, query, key, value, allowed)[0]
    plain = by_blocks(query, key, value)
    assert torch.allclose(found[0], plain[0], atol=1e-5)
    assert torch.allclose(found[1, :5], plain[1, :5], atol=1e-5)
    assert not torch.allclose(found[1, 6:], plain[1, 6:], atol=1e-3)
