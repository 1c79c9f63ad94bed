"""How much a run would ask, and what it says of it."""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import Any

import pytest

from probe.assets.library import open_all
from probe.bench.estimate import PICTURE_TOKENS, estimate
from probe.bench.models import known_models, settings_of
from probe.bench.prices import read_prices
from probe.cli.dry_run import would_ask
from probe.cli.model_run import ModelRunOptions, run_model
from probe.episodes.conditions import AS_FROZEN
from probe.episodes.files import write_records
from probe.episodes.folder import RECORDS
from probe.episodes.noise import NO_NOISE
from probe.episodes.participation import Participation
from probe.errors import BadData
from probe.tasks.suite_file import demo_suite
from probe.tasks.task import Task
from probe.types import Shard
from run_folders import episode

SUITE = demo_suite()
SEATS = ModelRunOptions(
    library=partial(open_all, None, Path("nowhere")),
    model="gpt-5.4", setting="agentic", epochs=3, points=None, pointer="oracle", endpoint=None,
    prices=None, noise=NO_NOISE, conditions=AS_FROZEN, shard=Shard(), workers=4,
)  # fmt: skip
PRICES = "gpt-5.4:\n  tokens_in: 2\n  tokens_out: 10\n"


def in_the_seat(task: Task, model: str = "gpt-5.4", setting: str = "agentic", **more: Any):
    return replace(episode(task, agent=model, **more), participation=Participation(setting))


def test_a_reply_in_words_costs_its_pictures_once():
    direct = estimate("direct", "pixels", SUITE.tasks, 3)
    blind = estimate("blind", "pixels", SUITE.tasks, 3)
    both = estimate("oracle-view", "pixels", SUITE.tasks, 3)
    assert (direct.episodes, direct.replies, direct.pictures) == (18, 18, 18)
    assert (blind.pictures, both.pictures) == (0, 36)
    assert both.tokens_in - blind.tokens_in > 36 * PICTURE_TOKENS


def test_without_pictures_none_is_counted():
    some = estimate("text-only", "pixels", SUITE.tasks[:1], 1, turns=4)
    seeing = estimate("agentic", "pixels", SUITE.tasks[:1], 1, turns=4)
    assert (some.replies, some.pictures) == (4, 0)
    assert seeing.tokens_in - some.tokens_in > 10 * PICTURE_TOKENS


def test_pictures_are_sent_again_with_each_reply():
    some = estimate("agentic", "pixels", SUITE.tasks[:1], 1, turns=4)
    # One with the first request, and one more with each later one.
    assert (some.replies, some.pictures) == (4, 1 + 2 + 3 + 4)
    most = estimate("agentic", "pixels", SUITE.tasks[:1], 1, turns=1000)
    assert most.replies == 40


def test_a_dry_run_asks_nothing_and_says_what_it_would_cost(tmp_path, capsys):
    path = tmp_path / "prices.yaml"
    path.write_text(PRICES)
    would_ask(SUITE, replace(SEATS, prices=path), tmp_path / "out")
    said = capsys.readouterr().out
    assert "6 tasks, 3 runs each: 18 episodes." in said
    assert "720 replies" in said and "US dollars" in said and "Nothing was asked" in said
    # No bound: replies may be longer than is assumed.
    assert "At most" not in said and "replies for 80: a model that reasons may write" in said
    assert not (tmp_path / "out").exists()


def test_a_dry_run_leaves_out_what_was_done(tmp_path, capsys):
    first, second = SUITE.tasks[:2]
    records = [
        in_the_seat(first, run=0), in_the_seat(first, run=2), in_the_seat(second, fault="gone"),
        in_the_seat(second, model="another"), in_the_seat(second, setting="direct"),
    ]  # fmt: skip
    write_records(tmp_path / RECORDS, records)
    would_ask(SUITE, SEATS, tmp_path)
    said = capsys.readouterr().out
    assert f"2 of them are in {tmp_path} already" in said
    assert f"{16 * 12} replies" in said and f"{16 * 40} replies" in said


@pytest.mark.parametrize(
    ("pointer", "endpoint", "setting"),
    [
        ("self", None, "agentic, pointer self"),
        ("gemini-3.1-pro", None, "agentic, pointer google/gemini-3.1-pro-preview"),
        ("mine", "http://localhost:9/v1", "agentic, pointer openai-api/endpoint/mine"),
    ],
)
def test_a_dry_run_knows_what_was_done_with_a_pointer(tmp_path, capsys, pointer, endpoint, setting):
    write_records(tmp_path / RECORDS, [in_the_seat(SUITE.tasks[0], setting=setting)])
    would_ask(SUITE, replace(SEATS, pointer=pointer, endpoint=endpoint), tmp_path)
    assert f"1 of them are in {tmp_path} already" in capsys.readouterr().out


def test_a_model_without_a_price_is_named(tmp_path, capsys):
    path = tmp_path / "prices.yaml"
    path.write_text(PRICES)
    would_ask(SUITE, replace(SEATS, model="mine", prices=path), tmp_path)
    said = capsys.readouterr().out
    assert "has no price of mine: no cost is told. Known: gpt-5.4." in said
    assert "US dollars" not in said


@pytest.mark.parametrize(
    ("model", "pointer", "words"),
    [
        ("mine", "oracle", "mine: is no short name.*--endpoint.*openai/mine"),
        ("qwen3-vl-8b", "oracle", r"vllm serve Qwen.*--max-model-len 65536\).*--endpoint"),
        ("openai/m", "theirs", "theirs: is no short name"),
    ],
)
def test_a_model_that_nobody_serves_is_refused_with_what_to_do(
    tmp_path, monkeypatch, model, pointer, words
):
    monkeypatch.delenv("VLLM_BASE_URL", raising=False)
    options = replace(SEATS, model=model, pointer=pointer)
    with pytest.raises(BadData, match=words):
        run_model(SUITE, options, tmp_path / "out")
    assert not (tmp_path / "out").exists()


def test_an_endpoint_without_a_scheme_is_none(tmp_path):
    options = replace(SEATS, model="mine", endpoint="localhost:8000/v1")
    with pytest.raises(BadData, match="Begin it with http://"):
        would_ask(SUITE, options, tmp_path)


def test_a_dry_run_says_that_pointing_comes_on_top(tmp_path, capsys):
    would_ask(SUITE, replace(SEATS, pointer="self"), tmp_path)
    assert "Replies that point (self) come on top" in capsys.readouterr().out


def test_prices_are_checked(tmp_path):
    path = tmp_path / "prices.yaml"
    path.write_text(PRICES)
    assert read_prices(path)["gpt-5.4"].tokens_out == 10
    path.write_text("gpt-5.4: 2\n")
    with pytest.raises(BadData, match="gpt-5.4"):
        read_prices(path)


def test_the_papers_models_have_settings():
    wanted = {
        "gemini-3.1-pro", "gemini-robotics-er-1.6", "gpt-5.4", "opus-4.7", "grok-4.3",
        "nemotron-2-vl", "qwen3.5-vl", "gemma-4",
    }  # fmt: skip
    assert wanted <= set(known_models())
    assert settings_of("gemini-3.1-pro").points == "0-1000"
    assert settings_of("openai/unheard-of").id == "openai/unheard-of"
