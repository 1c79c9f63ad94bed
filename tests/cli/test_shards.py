"""Shards as one writes them."""

from __future__ import annotations

import pytest

from probe.cli.shards import parse_shard
from probe.errors import BadData
from probe.types import Shard


def test_number_and_count():
    assert parse_shard("0/1") == Shard(0, 1)
    assert parse_shard("1/3") == Shard(1, 3)


@pytest.mark.parametrize("text", ["2/2", "0/0", "-1/2", "1", "a/b", "1/2/3", ""])
def test_what_is_no_part_is_refused(text):
    with pytest.raises(BadData, match=r"--shard: .*0/2"):
        parse_shard(text)
