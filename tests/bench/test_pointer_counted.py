"""What the model that points says: counted, priced and noted as everything else."""

from __future__ import annotations

import uuid

import anyio
import pytest
from inspect_ai.model import CachePolicy, get_model

from bench.sitting_in import NAME
from model_server import Reply, serving
from probe.bench.pointing import Pointing
from probe.bench.prices import Price
from probe.bench.usage import EpisodeUsage
from probe.runs.worker_messages import NoReply, PointerRequest

pytestmark = pytest.mark.filterwarnings("default")

MUG, BALL = PointerRequest((), "Point at the mug."), PointerRequest((), "Point at the ball.")


def ask_all(
    replies: list[Reply], questions: list[PointerRequest]
) -> tuple[list[str | NoReply], EpisodeUsage]:
    episode_usage = EpisodeUsage()
    cache = CachePolicy(expiry=None, scopes={"test": uuid.uuid4().hex})
    with serving(lambda number, body: replies[min(number, len(replies) - 1)]) as server:
        model = get_model(NAME, base_url=server.url, api_key="none", memoize=False, max_retries=0)
        pointing = Pointing(model, episode_usage, cache, Price(tokens_in=2, tokens_out=10))

        async def ask() -> list[str | NoReply]:
            return [await pointing(question) for question in questions]

        return anyio.run(ask), episode_usage


def test_replies_are_counted_once_each_and_priced():
    said, episode_usage = ask_all([Reply("[1, 2]"), Reply("[3, 4]")], [MUG, MUG, BALL])
    assert said == ["[1, 2]", "[1, 2]", "[3, 4]"]
    # The server counts 100 and 10 for each of two: 200 at 2 and 20 at 10 dollars a million.
    assert episode_usage.tokens == (200, 20)
    assert episode_usage.cost == pytest.approx(0.0006)
    assert episode_usage.faults == []


def test_an_empty_reply_is_the_models_own_failing():
    said, episode_usage = ask_all([Reply("")], [MUG])
    assert said == [""]
    assert episode_usage.faults == ["pointing 1: empty"]


def test_no_reply_is_ours_and_noted_without_the_request():
    (said,), episode_usage = ask_all([Reply(status=400)], [MUG])
    assert isinstance(said, NoReply)
    assert "400" in said.reason and "status 400" in said.reason
    assert "Point at the mug." not in said.reason
    assert episode_usage.faults[-1].startswith("pointing 1: none, ")
