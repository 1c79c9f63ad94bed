"""A model points for perception: the one that acts, or another in the role "pointer"."""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from typing import Any

import pytest
from inspect_ai.model import get_model

from bench.painted import demo, plan
from bench.sitting_in import answer, kept, replies_so_far, run_in, seat_of
from model_server import Reply, serving
from probe.assets.library import open_library
from probe.runs.episode_worker import EpisodeWorkerSetup

pytestmark = [pytest.mark.slow, pytest.mark.filterwarnings("default")]

SUITE = demo(1)
(TASK,) = SUITE.tasks
POT = (553, 426)
"""Pixel of the clay flower pot in the task's first picture, read off it by eye."""

FIND = ("find_object", '{"description": "the clay flower pot"}')


def acting(number: int, body: dict[str, Any]) -> Reply:
    """Asks for the same thing twice, then answers."""
    return Reply(calls=((FIND, FIND, answer("E"))[replies_so_far(body)],))


def pointing(number: int, body: dict[str, Any]) -> Reply:
    return Reply(f'{{"point": [{POT[0]}, {POT[1]}]}}')


def both(number: int, body: dict[str, Any]) -> Reply:
    return acting(number, body) if body.get("tools") else pointing(number, body)


def real(out, cache, pointer):
    library = partial(open_library, "procedural", None, cache)
    return replace(
        plan(out, "agentic", SUITE, cache=None, workers=1), library=library, pointer=pointer
    )


def check(record) -> None:
    found = record.steps[:2]
    assert [step.status for step in found] == ["done", "done"], record.fault
    for step in found:
        assert abs(step.point_px[0] - POT[0]) < 60 and abs(step.point_px[1] - POT[1]) < 60
        assert "object_" in step.text and "clay flower pot" not in step.text


def test_a_pointer_whose_server_sends_no_choice_is_asked_again(tmp_path, cache):
    """Though what it sent was kept, as every reply is."""
    sent = [0]

    def silent_first(number: int, body: dict[str, Any]) -> Reply:
        if body.get("tools"):
            return acting(number, body)
        sent[0] += 1
        return Reply(choices=0) if sent[0] == 1 else pointing(number, body)

    with serving(silent_first) as server:
        run_in(real(tmp_path, cache, "self"), server.url, EpisodeWorkerSetup, max_retries=0)
    record = kept(tmp_path)[TASK.id]
    check(record)
    assert record.end == "answered"
    assert any("no choice" in fault for fault in seat_of(record).faults)


def test_the_model_itself_points(tmp_path, cache):
    with serving(both) as server:
        run_in(real(tmp_path, cache, "self"), server.url, EpisodeWorkerSetup)
    record = kept(tmp_path)[TASK.id]
    assert record.setting == "agentic, pointer self"
    check(record)
    asked = [body for body in server.bodies if not body.get("tools")]
    assert len(asked) == 1, "the same question about the same picture is asked once"
    # Three replies that act and one that points; the server counts 100 and 10 tokens for each.
    seat = seat_of(record)
    assert (len(seat.replies), seat.tokens_in, seat.tokens_out) == (3, 400, 40)


def test_another_model_points(tmp_path, cache):
    with serving(acting) as server, serving(pointing) as other:
        role = get_model("openai-api/other/eyes", base_url=other.url, api_key="none")
        run_in(
            real(tmp_path, cache, "role"),
            server.url,
            EpisodeWorkerSetup,
            model_roles={"pointer": role},
        )
    record = kept(tmp_path)[TASK.id]
    assert record.setting == "agentic, pointer openai-api/other/eyes"
    check(record)
    assert (len(server.bodies), len(other.bodies)) == (3, 1)


def test_an_empty_pointing_reply_costs_a_turn_and_not_the_episode(tmp_path, cache):
    def mute(number: int, body: dict[str, Any]) -> Reply:
        return acting(number, body) if body.get("tools") else Reply("")

    with serving(mute) as server:
        run_in(real(tmp_path, cache, "self"), server.url, EpisodeWorkerSetup)
    record = kept(tmp_path)[TASK.id]
    assert record.end == "answered", record.fault
    assert [step.status for step in record.steps] == ["failed", "failed", "done"]
    # It is asked once more with the reason; the second call asks nothing new.
    assert seat_of(record).faults == ("pointing 1: empty", "pointing 2: empty")


def test_a_limit_reached_in_a_pointing_reply_ends_the_episode_without_an_answer(tmp_path, cache):
    with serving(both) as server:
        log = run_in(real(tmp_path, cache, "self"), server.url, EpisodeWorkerSetup, token_limit=200)
    record = kept(tmp_path)[TASK.id]
    # The reply that pointed is the second: 220 tokens by then, and its call came to nothing.
    assert (record.end, record.answer, record.steps) == ("stopped", None, ())
    assert log.samples and log.samples[0].limit and log.samples[0].limit.type == "token"
