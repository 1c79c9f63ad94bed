"""What is true of a laid table, sealed before an agent starts and opened afterwards."""

from __future__ import annotations

import hashlib
import json
import secrets
from dataclasses import asdict, dataclass


@dataclass(frozen=True)
class Truth:
    """What the operator says of the table that lies there.

    Attributes:
        answer: The letter that is right.
        note: In what the table differs from the picture; may be empty.
        salt: So many random digits that nobody finds the rest by trying letters.
    """

    answer: str
    note: str
    salt: str


def truth_of(answer: str, note: str) -> Truth:
    """A truth with a fresh salt of 32 hex digits."""
    return Truth(answer, note, secrets.token_hex(16))


def seal_of(truth: Truth) -> str:
    """SHA-256 of the JSON of answer, note and salt, in this order, without spaces; hex digits.

    Whoever has seen it before the episode can tell afterwards that the truth wasn't changed.
    """
    text = json.dumps(asdict(truth), separators=(",", ":"), ensure_ascii=False)
    return hashlib.sha256(text.encode()).hexdigest()
