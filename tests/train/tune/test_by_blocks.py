"""Attention by blocks gives what attention is defined to be, and its gradient."""

from __future__ import annotations

import math
from types import SimpleNamespace

import pytest

from probe.train.tune import libraries
from probe.train.tune.by_blocks import attend_by_blocks

pytestmark = pytest.mark.slow  # PyTorch

TOLERANCE = {"float64": 1e-9, "bfloat16": 0.02}
SHARP = 2.0
"""Times queries and keys: scores of a standard deviation of about 4, as trained models have."""


def defined(query, key, value):
    """softmax(q k^T / sqrt(width)) v over no later token; a key's head has several of queries.

    Of fewer queries than keys, these are the last ones.
    """
    torch = libraries.torch()
    key, value = (it.repeat_interleave(query.shape[1] // it.shape[1], 1) for it in (key, value))
    scores = torch.einsum("bhqd,bhkd->bhqk", query, key) / math.sqrt(query.shape[-1])
    tokens = torch.arange(key.shape[2])
    asking = tokens[key.shape[2] - query.shape[2] :]
    scores = scores.masked_fill(tokens[None, :] > asking[:, None], float("-inf"))
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


def small(attention: str):
    transformers = libraries.transformers()
    sizes = {"hidden_size": 48, "intermediate_size": 96, "num_hidden_layers": 1, "vocab_size": 9}
    config = transformers.LlamaConfig(**sizes, num_attention_heads=3, num_key_value_heads=1)
    return transformers.AutoModelForCausalLM.from_config(config, attn_implementation=attention)


@pytest.fixture(scope="module", autouse=True)
def registered():
    attend_by_blocks(small("sdpa"))


def test_a_model_that_attends_otherwise_keeps_that():
    """Some can't attend by the kernel, since theirs has a cap or sinks."""
    other, usual = small("eager"), small("sdpa")
    attend_by_blocks(other)
    attend_by_blocks(usual)
    assert other.config._attn_implementation == "eager"
    assert usual.config._attn_implementation == "by_blocks"


@pytest.mark.parametrize("causal", [False, True])
def test_what_sees_all_tokens_still_does(causal):
    """The parts of a model that look at pictures."""
    torch = libraries.torch()
    torch.manual_seed(0)
    query, key, value = (torch.randn(1, 3, 40, 16) for _ in range(3))
    attention = libraries.part("transformers").AttentionInterface()["by_blocks"]
    module = SimpleNamespace(is_causal=causal, num_key_value_groups=1)
    found = attention(module, query, key, value, None, is_causal=None)[0]
    value[:, :, -1] += 1
    changed = attention(module, query, key, value, None, is_causal=None)[0]
    assert torch.equal(found[:, :-1], changed[:, :-1]) is causal


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


@pytest.mark.parametrize("biased", [False, True])
@pytest.mark.parametrize(("tokens", "before"), [(1, 40), (5, 1), (300, 500), (256, 256)])
def test_a_text_that_goes_on(tokens, before, biased):
    """By blocks, and by the kernel where something else is asked that blocks don't do."""
    torch = libraries.torch()
    torch.manual_seed(tokens)
    query = torch.randn(1, 6, tokens, 16)
    key, value = (torch.randn(1, 2, before + tokens, 16) for _ in range(2))
    more = {"position_bias": torch.zeros(1, 1, tokens, before + tokens)} if biased else {}
    attention = libraries.part("transformers").AttentionInterface()["by_blocks"]
    module = SimpleNamespace(is_causal=True, num_key_value_groups=3)
    found = attention(module, query, key, value, None, **more)[0]
    wanted = defined(query, key, value)
    assert (found - wanted).norm() < 1e-5 * wanted.norm()


def test_sharp_attention_over_many_tokens():
    torch = libraries.torch()
    torch.manual_seed(3)
    query, key, value = (torch.randn(1, n, 2048, 64) for n in (2, 1, 1))
    inputs = [query * SHARP, key * SHARP, value]
    found = with_gradients(by_blocks, inputs, torch.bfloat16)
    wanted = with_gradients(defined, inputs, torch.float64)
    for mine, other in zip(found, wanted, strict=True):
        assert (mine.double() - other).norm() < 0.02 * other.norm()


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
