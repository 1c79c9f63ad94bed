"""What tokens cost, worked out by hand."""

from __future__ import annotations

import pytest
from inspect_ai.model import ModelUsage

from probe.bench.prices import Price, cost_of, tokens_in

PLAIN, CACHED = Price(tokens_in=2, tokens_out=10), Price(tokens_in=2, tokens_out=10, cached=0.5)
FRESH = ModelUsage(input_tokens=1000, output_tokens=50)
# The harness counts what the server has already, or keeps from now on, beside input_tokens.
KNOWN = ModelUsage(
    input_tokens=1000, output_tokens=50, input_tokens_cache_read=4000, input_tokens_cache_write=600
)


def test_tokens_of_requests_are_all_that_were_sent():
    assert (tokens_in(FRESH), tokens_in(KNOWN)) == (1000, 5600)


@pytest.mark.parametrize(
    ("usage", "price", "dollars"),
    [
        (FRESH, None, None),
        (FRESH, PLAIN, 0.0025),  # 1000 x 2 + 50 x 10 millionths
        (KNOWN, PLAIN, 0.0117),  # 5600 x 2 + 50 x 10
        (KNOWN, CACHED, 0.0057),  # 1600 x 2 + 4000 x 0.5 + 50 x 10
        (KNOWN, Price(tokens_in=2, tokens_out=10, cached=0), 0.0037),
    ],
)
def test_a_cost_is_worked_out(usage, price, dollars):
    found = cost_of(usage, price)
    assert found is None if dollars is None else found == pytest.approx(dollars)
