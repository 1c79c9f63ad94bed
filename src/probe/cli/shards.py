"""Shards on the command line: which part of the work a process does."""

from __future__ import annotations

import re

from probe.errors import BadData
from probe.types import Shard


def parse_shard(text: str) -> Shard:
    """A shard as one writes it: "0/2" is the first half.

    Raises:
        BadData: It is none.
    """
    found = re.fullmatch(r"([0-9]{1,6})/([0-9]{1,6})", text)
    if not found or int(found[1]) >= int(found[2]):
        raise BadData("--shard", f"{text!r} is no part of the work", 'Say "0/2" or "1/2".')
    return Shard(int(found[1]), int(found[2]))
