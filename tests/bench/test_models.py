"""What a model is called where it is asked: as records name one that points."""

from __future__ import annotations

import pytest

from probe.bench.evaluation import Participants, _model
from probe.bench.models import asked_as

ENDPOINT = "http://localhost:9/v1"
QWEN = "openai-api/vllm/Qwen/Qwen3-VL-8B-Instruct"


@pytest.fixture(autouse=True)
def keys(monkeypatch):
    for name in ("OPENAI", "ANTHROPIC", "GOOGLE", "VLLM"):
        monkeypatch.setenv(f"{name}_API_KEY", "none")
    monkeypatch.setenv("VLLM_BASE_URL", ENDPOINT)


@pytest.mark.parametrize(
    ("name", "endpoint", "called"),
    [
        ("eyes", ENDPOINT, "openai-api/endpoint/eyes"),
        ("mine", ENDPOINT, "openai-api/endpoint/mine"),
        (QWEN, ENDPOINT, "openai-api/endpoint/Qwen/Qwen3-VL-8B-Instruct"),
        (QWEN, None, QWEN),
        ("openai/gpt-5.4", ENDPOINT, "openai/gpt-5.4"),
        ("openai/gpt-5.4", None, "openai/gpt-5.4"),
        ("anthropic/claude-opus-4-7", None, "anthropic/claude-opus-4-7"),
        ("google/gemini-3.1-pro-preview", None, "google/gemini-3.1-pro-preview"),
    ],
)
def test_a_name_is_known_before_the_harness_is_asked(name, endpoint, called):
    assert asked_as(name, "mine", endpoint) == called
    assert str(_model(Participants("mine", endpoint), name)) == called


def test_the_one_that_acts_is_at_the_endpoint_whatever_its_name():
    name = "openai/gpt-5.4"
    assert asked_as(name, name, ENDPOINT) == "openai-api/endpoint/openai/gpt-5.4"
    assert str(_model(Participants(name, ENDPOINT), name)) == asked_as(name, name, ENDPOINT)
