"""What the replies of an episode cost: all of them together, or nobody knows."""

from __future__ import annotations

import pytest
from inspect_ai.model import ModelOutput, ModelUsage, StopReason

from probe.bench.prices import Price
from probe.bench.usage import EpisodeUsage

PRICE = Price(tokens_in=2, tokens_out=10)
PRICED, UNPRICED, SILENT = (True, PRICE), (True, None), (False, PRICE)
"""Replies: whether the server says how many tokens, and their price."""

TOKENS, DOLLARS = (100, 10), 0.0003


def reply(*, told: bool, stop: StopReason = "stop") -> ModelOutput:
    output = ModelOutput.from_content("m", "Well.", stop_reason=stop)
    output.usage = ModelUsage(input_tokens=100, output_tokens=10) if told else None
    return output


def usage_of(*replies: tuple[bool, Price | None]) -> EpisodeUsage:
    counted = EpisodeUsage()
    for number, (told, price) in enumerate(replies, start=1):
        counted.count(f"reply {number}", reply(told=told), price)
    return counted


@pytest.mark.parametrize("which", [[PRICED, UNPRICED, PRICED], [UNPRICED, PRICED], [UNPRICED]])
def test_a_reply_without_a_price_leaves_no_cost(which):
    counted = usage_of(*which)
    assert counted.cost is None
    assert counted.tokens == (100 * len(which), 10 * len(which))


@pytest.mark.parametrize("which", [[PRICED, SILENT, PRICED], [SILENT, PRICED], [SILENT]])
def test_a_reply_whose_tokens_nobody_says_leaves_no_count_and_no_cost(which):
    counted = usage_of(*which)
    assert (counted.tokens, counted.cost) == (None, None)


def test_without_replies_nothing_is_known():
    assert (usage_of().tokens, usage_of().cost) == (None, None)


@pytest.mark.parametrize("stop", ["content_filter", "model_length"])
def test_a_request_that_was_refused_costs_nothing(stop):
    counted = usage_of(PRICED)
    counted.count("reply 2", reply(told=False, stop=stop), PRICE)
    assert counted.tokens == TOKENS and counted.cost == pytest.approx(DOLLARS)
    (fault,) = counted.faults
    assert fault.startswith("reply 2: ")
