"""A run stops where no other episode would fare better, and says why; the same command goes on."""

from __future__ import annotations

from dataclasses import replace
from importlib.util import find_spec

import pytest

from bench.odd_tables import UnfitPlace
from bench.painted import demo, plan
from bench.sitting_in import run_in
from model_server import Reply, serving
from probe.bench.evaluation import Participants, evaluate
from probe.bench.stopping import MUTE, SilenceLimit
from probe.episodes.files import read_records
from probe.episodes.folder import RECORDS
from probe.errors import MissingExtra, ModelFailed

pytestmark = pytest.mark.filterwarnings("default")

SUITE = demo(2)
NOWHERE = "http://127.0.0.1:9/v1"


def test_patience_ends_with_episodes_in_a_row():
    patience = SilenceLimit()
    for _ in range(2):
        for _ in range(MUTE - 1):
            patience.heard(True, "refused")
        patience.heard(False, None)
    for _ in range(MUTE - 1):
        patience.heard(True, "refused")
    with pytest.raises(ModelFailed, match="refused"):
        patience.heard(True, "refused")


@pytest.mark.slow
def test_a_server_that_isnt_there_costs_seconds(tmp_path):
    with pytest.raises(ModelFailed, match="mine doesn't answer.*--endpoint"):
        evaluate(plan(tmp_path, "agentic", SUITE), Participants("mine", NOWHERE), "none")
    assert not (tmp_path / RECORDS).exists()


def test_an_unknown_pointer_is_named_before_anything_is_asked(tmp_path):
    asked = replace(plan(tmp_path, "agentic", SUITE), pointer="role")
    with pytest.raises(ModelFailed, match="oracel can't be asked"):
        evaluate(asked, Participants("mockllm/model", pointer="oracel"), "none")
    assert not (tmp_path / RECORDS).exists()


def test_a_client_that_isnt_installed_is_named(tmp_path):
    if find_spec("xai_sdk") is not None:
        pytest.skip("xAI's client is installed")
    with pytest.raises(MissingExtra, match=r"grok/grok-4.3 needs .*'\.\[bench,grok\]'"):
        evaluate(plan(tmp_path, "agentic", SUITE), Participants("grok/grok-4.3"), "none")
    assert not (tmp_path / RECORDS).exists()


def test_what_the_harness_says_is_told_without_its_markup(tmp_path, monkeypatch):
    """It dresses the missing key's name up in brackets, for a terminal."""
    monkeypatch.delenv("OPENAI_API_KEY", raising=False)
    with pytest.raises(ModelFailed, match="OPENAI_API_KEY") as told:
        evaluate(plan(tmp_path, "agentic", SUITE), Participants("openai/gpt-5.4"), "none")
    assert "[bold" not in str(told.value) and "[/" not in str(told.value)


@pytest.mark.slow
def test_a_model_that_never_says_anything_isnt_asked_for_ever(tmp_path):
    asked = plan(tmp_path, "blind", SUITE, epochs=8)
    with serving(lambda number, body: Reply(status=400)) as server:
        log = run_in(asked, server.url, max_retries=0)
    assert log.status == "error"
    assert log.error and f"{MUTE} episodes one after another" in log.error.message
    assert MUTE <= len(read_records(tmp_path / RECORDS)) < 16


@pytest.mark.slow
def test_tables_that_cant_be_set_up_stop_a_run_at_once(tmp_path):
    asked = plan(tmp_path, "agentic", SUITE, workers=1, epochs=3)
    with serving(lambda number, body: Reply("Hello.")) as server:
        log = run_in(asked, server.url, UnfitPlace)
    assert log.status == "error" and log.error and "no driver" in log.error.message
    assert (tmp_path / "deaths").read_text() == "tried\n"
    assert server.bodies == [] and not (tmp_path / RECORDS).exists()
