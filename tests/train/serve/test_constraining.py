"""Replies of untrained models that are kept to the tools' calls."""

from __future__ import annotations

import json

import pytest
from jsonschema import validate

from probe.train.serve.constraining import MOST_WORDS, CallForms, grammar_of
from probe.train.serve.speaking import ServedModel
from probe.train.tune import libraries
from probe.train.tune.conversations import NotUnderstood
from probe.train.tune.loading import load
from probe.transcripts.tools import as_sent
from small_models import small_dataset, small_model

pytestmark = [pytest.mark.slow, pytest.mark.filterwarnings("default")]

TOOLS = as_sent("0-1000", setting="text-only")
SCHEMAS = {tool["function"]["name"]: tool["function"]["parameters"] for tool in TOOLS}
ASKED = {"messages": [{"role": "user", "content": "What is under the mug?"}], "tools": TOOLS}
RIGHT = (
    'I look.\n<tool_call>\n{"name": "push", "arguments": {"object_id": "object_1", '
    '"direction": "up", "distance_cm": 5}}\n</tool_call>'
)


@pytest.fixture(scope="module")
def model(tmp_path_factory):
    dataset = small_dataset(tmp_path_factory.mktemp("dataset"), pictures=False)
    return small_model(tmp_path_factory.mktemp("model"), dataset, pictures=False)


def test_whatever_it_would_say_each_reply_is_a_call_that_fits(model):
    """Weights are random, and replies are drawn: free ones hold no call at all."""
    libraries.torch().manual_seed(5)
    kept, free = ServedModel(str(model), constrained=True), ServedModel(str(model))
    body = ASKED | {"temperature": 1.0, "max_tokens": 1200}
    called = set()
    for _ in range(12):
        assert not free.reply(body | {"max_tokens": 40}).reply.calls
        said = kept.reply(body)
        if said.cut:  # a number of a thousand digits, say
            continue
        ((name, arguments),) = said.reply.calls
        validate(json.loads(arguments), SCHEMAS[name])
        assert "<" not in said.reply.words and len(said.reply.words) <= MOST_WORDS
        called.add(name)
    assert len(called) >= 2


def test_a_request_without_tools_is_answered_freely(model):
    free, kept = ServedModel(str(model)), ServedModel(str(model), constrained=True)
    body = {"messages": ASKED["messages"], "max_tokens": 12}
    assert kept.reply(body) == free.reply(body)


def allowed(forms: CallForms, tokenizer, text: str) -> int:
    """How many of a reply's tokens, and of the end behind it, are allowed one after the other."""
    torch = libraries.torch()
    tokens = [*tokenizer(text, add_special_tokens=False)["input_ids"], tokenizer.eos_token_id]
    keep, said = forms.keep_to(TOOLS), [0]
    for token in tokens:
        scores = keep(torch.tensor([said]), torch.zeros(1, len(tokenizer)))
        if scores[0, token] < 0:
            break
        said.append(token)
    return len(said) - 1 - len(tokens)


@pytest.mark.parametrize(
    "wrong",
    [
        "I look.",
        RIGHT.replace("push", "pull"),
        RIGHT.replace("up", "north"),
        RIGHT.replace("5", '"5"'),
        RIGHT.replace(', "distance_cm": 5', ""),
        RIGHT.replace('"object_id"', '"id"'),
        RIGHT.replace("\n</tool_call>", ""),
        RIGHT + RIGHT,
    ],
)
def test_what_the_tools_take_is_allowed_and_what_they_refuse_is_not(model, wrong):
    tokenizer = load(str(model))[1]
    forms = CallForms(tokenizer)
    assert allowed(forms, tokenizer, RIGHT) == 0
    assert allowed(forms, tokenizer, wrong) < 0


def test_a_schema_that_cannot_be_kept_to_is_named(model):
    odd = {"type": "object", "properties": {"x": {"type": "string", "not": {"const": "a"}}}}
    tools = [{"type": "function", "function": {"name": "odd", "parameters": odd}}]
    served = ServedModel(str(model), constrained=True)
    with pytest.raises(NotUnderstood, match=r"kept to its tools' schemas .*without --constrained"):
        served.reply(ASKED | {"tools": tools})


@pytest.mark.parametrize("tools", [[{"type": "function"}], "oops", [{"function": {"name": 3}}, 4]])
def test_tools_in_another_form_are_not_understood(tools):
    with pytest.raises(NotUnderstood, match="aren't functions with names"):
        grammar_of(tools, "<tool_call>", "</tool_call>")


def test_a_tool_without_parameters_takes_none_in_particular():
    tools = [{"type": "function", "function": {"name": "look", "parameters": None}}]
    assert '"type": "object"' in grammar_of(tools, "<tool_call>", "</tool_call>")
