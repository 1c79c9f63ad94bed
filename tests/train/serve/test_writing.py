"""Replies that are written side by side are those that are written alone."""

from __future__ import annotations

from concurrent.futures import Future, ThreadPoolExecutor
from threading import Barrier, Event, Semaphore
from time import sleep

import pytest

from probe.errors import BadData
from probe.train.serve.choosing import Chooser, check_recommended
from probe.train.serve.next_token import attend_to_next
from probe.train.serve.writing import GivenUp, Writer
from probe.train.tune import libraries
from probe.train.tune.by_blocks import attend_by_blocks

pytestmark = pytest.mark.slow  # PyTorch

ENDS = frozenset([7])
TEXTS = [[(3 * place + n) % 50 + 8 for place in range(40 + 90 * n)] for n in range(5)]
MOST = (30, 12, 25, 3, 30)


def small(attention: str = "sdpa", **more):
    transformers, torch = libraries.transformers(), libraries.torch()
    torch.manual_seed(0)
    sizes = {"hidden_size": 48, "intermediate_size": 96, "num_hidden_layers": 3, "vocab_size": 300}
    heads = {"num_attention_heads": 6, "num_key_value_heads": 2}
    config = transformers.LlamaConfig(**sizes, **heads, eos_token_id=7, **more)
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


class Announced(list[int]):
    """A conversation that says when it is taken."""

    def __init__(self, tokens, taken: Semaphore) -> None:
        super().__init__(tokens)
        self._taken = taken

    def __iter__(self):
        self._taken.release()
        return super().__iter__()


def together(model, writer: Writer, choosers) -> list[Future[list[int]]]:
    """Replies of 20 tokens to as many requests, none of which is begun before all wait."""
    taken, begin = Semaphore(0), Event()
    hook = model.register_forward_pre_hook(lambda *_: (begin.wait(), None)[1])
    with ThreadPoolExecutor(len(choosers)) as pool:
        found = [
            pool.submit(writer.write, Announced(text, taken), 20, each)
            for text, each in zip(TEXTS, choosers, strict=False)
        ]
        for _ in found:
            taken.acquire()
        sleep(0.2)
        begin.set()
    hook.remove()
    return found


def test_several_take_a_step_together():
    """Counted by what the model is given: each is read, in a step of those before it."""
    model = small()
    assert attend_to_next(model)
    sizes = list[int]()
    model.register_forward_pre_hook(lambda _, given: sizes.append(len(given[0])))
    found = together(model, Writer(model, 3, frozenset()), [chooser(model)] * 3)
    assert [len(it.result()) for it in found] == [20, 20, 20]
    assert [sizes.count(size) for size in (1, 2, 3)] == [3 + 2, 2, 17]


def test_who_gives_up_leaves_the_place_to_the_next():
    """While its reply is written, or while it waits for its turn."""
    model = small()
    assert attend_to_next(model)
    writer, given_up, steps = Writer(model, 1, frozenset()), Event(), list[int]()

    def count(_, given):
        steps.append(given[0].shape[1])
        if len(steps) == 5:
            given_up.set()

    hook = model.register_forward_pre_hook(count)
    with pytest.raises(GivenUp):
        writer.write(TEXTS[0], 200, chooser(model), given_up)
    assert len(steps) == 5
    with pytest.raises(GivenUp):
        writer.write(TEXTS[1], 200, chooser(model), given_up)
    assert len(steps) == 5
    # What was read is known to who asks again.
    assert writer.write(TEXTS[0], 3, chooser(model)) == generated(small(), TEXTS[0], 3)
    assert steps[0] == len(TEXTS[0]) and steps[5] == 1
    hook.remove()
    assert writer.write(TEXTS[2], 12, chooser(model)) == generated(small(), TEXTS[2], 12)


def test_an_error_in_a_step_reaches_all_it_was_for_and_the_next_is_written():
    model = small()
    assert attend_to_next(model)

    def fail(_, given):
        if len(given[0]) == 3:
            raise MemoryError("none is left")

    hook = model.register_forward_pre_hook(fail)
    writer = Writer(model, 3, ENDS)
    found = together(model, writer, [chooser(model)] * 3)
    assert all(isinstance(it.exception(), MemoryError) for it in found)
    hook.remove()
    assert writer.write(TEXTS[2], 25, chooser(model)) == generated(small(), TEXTS[2], 25)


@pytest.mark.parametrize("at", [0, 4])
def test_an_error_of_one_reply_is_told_of_that_alone(at):
    model = small()
    assert attend_to_next(model)

    def fail(tokens, scores):
        if tokens.shape[1] == len(TEXTS[1]) + at:
            raise ValueError("no token may follow")
        return scores

    failing = Chooser(model.generation_config, 0.0, fail)
    found = together(model, Writer(model, 3, ENDS), [chooser(model), failing, chooser(model)])
    with pytest.raises(ValueError, match="no token may follow"):
        found[1].result()
    for place in (0, 2):
        assert found[place].result() == generated(small(), TEXTS[place], 20)


def test_a_cache_that_is_cut_and_copied_is_its_own():
    """Of two conversations that begin alike, in turn."""
    model = small()
    assert attend_to_next(model)
    writer, first = Writer(model, 1, ENDS), TEXTS[1]
    told = [first, [*first[:30], *range(20, 60)]]
    for _ in range(3):
        for place, text in enumerate(told):
            reply = writer.write(text, 9, chooser(model))
            assert reply == generated(small(), text, 9)
            told[place] = [*text, *reply, 11, 12]


@pytest.mark.parametrize(
    "how",
    [
        {"attention": "eager"},
        {"sliding_window": 16},
        {"attention_chunk_size": 16},
        {"layer_types": ["full_attention", "linear_attention", "full_attention"]},
        {"rope_parameters": {"rope_type": "dynamic", "rope_theta": 10000.0, "factor": 2.0}},
    ],
)
def test_models_that_attend_otherwise_keep_that(how):
    model = small(**how)
    before = model.config._attn_implementation
    assert not attend_to_next(model) and model.config._attn_implementation == before


@pytest.mark.parametrize(
    ("key", "value", "warmth"),
    [
        ("repetition_penalty", 1.7, 0.0),
        ("top_k", None, 9.0),
        ("top_k", 2, 1.0),
        ("top_p", 0.3, 1.5),
        ("min_p", 0.4, 1.5),
    ],
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
    check_recommended("model", model.generation_config)
    torch.manual_seed(3)
    assert Writer(model, 1, ENDS).write(text, 20, chooser(model, warmth)) == made


def test_what_isnt_kept_to_is_refused():
    config = libraries.transformers().GenerationConfig(no_repeat_ngram_size=3, top_k=20)
    with pytest.raises(BadData, match=r"mine: generation_config.json: .*no_repeat_ngram_size = 3"):
        check_recommended("mine", config)
