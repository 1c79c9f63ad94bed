from __future__ import annotations

import pytest

from probe.train.serve.read_before import ReadBefore, shared


class Cache:
    """Holds so many tokens."""

    def __init__(self) -> None:
        self.tokens: list[int] = []

    def get_seq_length(self) -> int:
        return len(self.tokens)

    def crop(self, length: int) -> None:
        assert length < 0
        del self.tokens[length:]


def reply(before: ReadBefore, asked: list[int], said: list[int]) -> int:
    """How many tokens a model had to read, which then keeps all but the last one it said."""
    cache = before.begin(asked)
    known = cache.get_seq_length()
    assert cache.tokens == asked[:known]
    whole = [*asked, *said]
    cache.tokens = whole[:-1]
    before.keep(whole, cache)
    return len(asked) - known


def test_a_conversation_that_goes_on_is_read_from_where_it_was():
    before = ReadBefore(Cache)
    assert reply(before, [1, 2, 3], [4, 5]) == 3
    # The last word said isn't in the cache.
    assert reply(before, [1, 2, 3, 4, 5, 6, 7], [8]) == 3
    assert reply(before, [1, 2, 3, 4, 5, 6, 7, 8, 9], [1]) == 2


def test_another_conversation_shares_the_rules_and_spoils_nothing():
    before = ReadBefore(Cache)
    reply(before, [1, 2, 3, 4], [5])
    assert reply(before, [1, 2, 7, 8], [9]) == 2
    assert reply(before, [1, 2, 3, 4, 5, 6], [7]) == 2
    assert reply(before, [1, 2, 7, 8, 9, 9], [7]) == 2


def test_the_same_request_again_reads_one_token():
    before = ReadBefore(Cache)
    reply(before, [1, 2, 3], [4, 5, 6])
    assert reply(before, [1, 2, 3], [4, 5, 6]) == 1


def test_the_oldest_is_given_up():
    before = ReadBefore(Cache, most=2)
    for first in (1, 2, 3):
        reply(before, [first, 9, 9, 9], [0])
    assert reply(before, [1, 9, 9, 9, 0], [0]) == 5
    assert reply(before, [3, 9, 9, 9, 0], [0]) == 1


@pytest.mark.parametrize(
    ("one", "other", "same"), [([], [1], 0), ([1, 2], [1, 3], 1), ([1, 2], [1, 2, 3], 2)]
)
def test_what_two_texts_share(one, other, same):
    assert shared(one, other) == same
