"""Why no reply came, in words that say whose doing it is."""

from __future__ import annotations

import json

import pytest

from probe.bench.reasons import explained, said


def broken() -> list[Exception]:
    found: list[Exception] = []
    for sent in (b"\xff", b"no json"):
        try:
            json.loads(sent.decode())
        except ValueError as error:
            found.append(error)
    return [*found, AttributeError("'int' object has no attribute 'x'"), TypeError("a number")]


@pytest.mark.parametrize("error", broken(), ids=lambda error: type(error).__name__)
def test_a_reply_unlike_the_protocol_is_called_that(error):
    told = said(error)
    assert told.startswith(f"its reply doesn't follow the protocol ({type(error).__name__}: ")
    assert explained(repr(error)) == f"its reply doesn't follow the protocol ({error!r})"


def test_a_refusal_is_none_of_these():
    assert said(RuntimeError("503 too busy")) == "RuntimeError: 503 too busy"
    assert explained("Too many TypeErrors") == "Too many TypeErrors"
