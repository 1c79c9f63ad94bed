"""The loss over learnt tokens alone is the loss that Transformers takes over all of them."""

from __future__ import annotations

import pytest

from probe.train.tune import libraries
from probe.train.tune.by_blocks import attend_by_blocks
from probe.train.tune.learnt_tokens import learnt_loss

pytestmark = pytest.mark.slow  # PyTorch


@pytest.fixture(scope="module")
def model():
    transformers, torch = libraries.transformers(), libraries.torch()
    torch.manual_seed(0)
    sizes = {"hidden_size": 48, "intermediate_size": 96, "num_hidden_layers": 2}
    heads = {"num_attention_heads": 3, "num_key_value_heads": 1, "vocab_size": 99}
    return transformers.LlamaForCausalLM(transformers.LlamaConfig(**sizes, **heads))


def batch(rows: int):
    """Tokens of which each row learns others, the last one with a filler at its end."""
    torch = libraries.torch()
    torch.manual_seed(1)
    ids = torch.randint(1, 99, (rows, 300))
    labels = torch.full_like(ids, -100)
    for row in range(rows):
        labels[row, 100 + 50 * row : 130 + 60 * row] = ids[row, 100 + 50 * row : 130 + 60 * row]
    mask = torch.ones_like(ids)
    if rows > 1:
        mask[-1, -20:] = 0
    return {"input_ids": ids, "attention_mask": mask, "labels": labels}


def gradients(model, loss):
    model.zero_grad()
    loss.backward()
    return [it.grad.clone() for it in model.parameters()]


@pytest.mark.parametrize("rows", [1, 3])
def test_it_is_the_same_loss_with_the_same_gradient(model, rows):
    torch, inputs = libraries.torch(), batch(rows)
    model.set_attn_implementation("eager")
    whole = model(**inputs).loss
    wanted = gradients(model, whole)
    model.set_attn_implementation("sdpa")
    attend_by_blocks(model)
    assert model.config._attn_implementation == "by_blocks"
    loss = learnt_loss(model, inputs)
    assert loss.item() == pytest.approx(whole.item(), rel=1e-5)
    for mine, other in zip(gradients(model, loss), wanted, strict=True):
        assert torch.allclose(mine, other, atol=1e-6)


def test_where_nothing_is_learnt_nothing_changes(model):
    inputs = batch(1)
    loss = learnt_loss(model, inputs | {"labels": inputs["labels"] * 0 - 100})
    assert loss.item() == 0.0


def test_a_step_of_several_batches_divides_by_all_their_tokens(model):
    inputs = batch(1)
    alone = learnt_loss(model, inputs)
    half = learnt_loss(model, inputs, 60)
    assert half.item() == pytest.approx(alone.item() * 30 / 60)
