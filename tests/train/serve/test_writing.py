"""Replies that are written side by side are those that are written alone."""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from threading import Barrier, Lock

import pytest

from probe.train.serve.choosing import Chooser
from probe.train.serve.next_token import attend_to_next
from probe.train.serve.writing import Writer
from probe.train.tune import libraries
from probe.train.tune.by_blocks import attend_by_blocks

pytestmark = pytest.mark.slow  # PyTorch

ENDS = frozenset([7])
TEXTS = [[(3 * place + n) % 50 + 8 for place in range(40 + 90 * n)] for n in range(5)]
MOST = (30, 12, 25, 3, 30)


def small(attention: str = "sdpa", **more):
    transformers, torch = libraries.transformers(), libraries.torch()
    torch.manual_seed(0)
    sizes = {"hidden_size": 48, "intermediate_size": 96, "num_hidden_layers": 3, "vocab_size": 60}
    config = transformers.LlamaConfig(
        **sizes, num_attention_heads=6, num_key_value_heads=2, eos_token_id=7, **more
    )
    made = transformers.AutoModelForCausalLM.from_config(config, attn_implementation=attention)
    for weight in made.parameters():  # as sharp as trained ones, so that replies differ
        weight.data *= 4
    return made.eval()


def chooser(model, warmth: float = 0.0) -> Chooser:
    return Chooser(model.generation_config, warmth)


def generated(model, text: list[int], most: int) -> list[int]:
    """As Transformers writes it."""
    torch = libraries.torch()
    with torch.inference_mode():
        made = model.generate(torch.tensor([text]), max_new_tokens=most, do_sample=False)
    return made[0, len(text) :].tolist()


@pytest.mark.parametrize("by_blocks", [False, True])
@pytest.mark.parametrize("at_once", [1, 2, 4])
def test_each_is_what_transformers_writes(at_once, by_blocks):
    wanted = [generated(small(), text, most) for text, most in zip(TEXTS, MOST, strict=True)]
    assert len({tuple(reply) for reply in wanted}) == len(TEXTS)
    model = small()
    if by_blocks:
        attend_by_blocks(model)
    assert attend_to_next(model)
    writer, together = Writer(model, at_once, ENDS), Barrier(len(TEXTS))

    def write(text: list[int], most: int) -> list[int]:
        together.wait()
        return writer.write(text, most, chooser(model))

    with ThreadPoolExecutor(len(TEXTS)) as pool:
        assert list(pool.map(write, TEXTS, MOST)) == wanted
    # And where each conversation goes on, after others were.
    longer = [[*text, *reply, 9, 10, 11] for text, reply in zip(TEXTS, wanted, strict=True)]
    for text, most in zip(longer, MOST, strict=True):
        assert writer.write(text, most, chooser(model)) == generated(small(), text, most)


def test_several_take_a_step_together():
    """Counted by what the model is given."""
    model = small()
    assert attend_to_next(model)
    sizes, together = list[int](), Barrier(3)
    model.register_forward_pre_hook(lambda _, given: sizes.append(len(given[0])))
    writer = Writer(model, 3, frozenset())

    def write(text: list[int]) -> int:
        together.wait()
        return len(writer.write(text, 20, chooser(model)))

    with ThreadPoolExecutor(3) as pool:
        assert list(pool.map(write, TEXTS[:3])) == [20, 20, 20]
    assert max(sizes) == 3 and len(sizes) < 3 * 20


def test_an_error_reaches_all_who_wait_and_the_next_is_written():
    model, lock = small(), Lock()
    assert attend_to_next(model)
    left = [5]

    def fail(_, given):
        with lock:
            left[0] -= 1
            if left[0] == 0:
                raise MemoryError("none is left")

    hook = model.register_forward_pre_hook(fail)
    writer = Writer(model, 2, ENDS)
    with ThreadPoolExecutor(2) as pool:
        asked = [pool.submit(writer.write, text, 30, chooser(model)) for text in TEXTS[:2]]
        errors = [it.exception() for it in asked]
    hook.remove()
    assert any(isinstance(error, MemoryError) for error in errors)
    assert writer.write(TEXTS[2], 25, chooser(model)) == generated(small(), TEXTS[2], 25)


@pytest.mark.parametrize("how", [{"attention": "eager"}, {"sliding_window": 16}])
def test_models_that_attend_otherwise_keep_that(how):
    model = small(**how)
    before = model.config._attn_implementation
    assert not attend_to_next(model) and model.config._attn_implementation == before


@pytest.mark.parametrize(
    ("key", "value", "warmth"),
    [("repetition_penalty", 1.7, 0.0), ("top_k", 2, 1.0), ("top_p", 0.3, 1.5), ("min_p", 0.4, 1.5)],
)
def test_what_a_model_recommends_is_kept_to(key, value, warmth):
    """As by generate(), which reads the same file; in float32, too, for draws to be the same."""
    torch, model, text = libraries.torch(), small(), TEXTS[0]
    setattr(model.generation_config, key, value)
    torch.manual_seed(3)
    with torch.inference_mode():
        how = {"max_new_tokens": 20, "do_sample": warmth > 0, "temperature": warmth or None}
        made = model.generate(torch.tensor([text]), **how)[0, len(text) :].tolist()
    assert made != generated(small(), text, 20)
    attend_to_next(model)
    torch.manual_seed(3)
    assert Writer(model, 1, ENDS).write(text, 20, chooser(model, warmth)) == made
