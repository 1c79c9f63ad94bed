"""A private suite's secret: whoever has it can make the tasks again, nobody else foretell one."""

from __future__ import annotations

import hashlib
import hmac
import secrets
from dataclasses import dataclass, field

import numpy as np

SALT_BYTES = 32

PRIVATE_FROM = 1 << 127
"""Seeds that private tasks bear are at least this; all others are far below."""

_COMMITTED = b"PROBE suite salt, version 1\0"
_NUMBER_BYTES = 16
_SEALED_BITS = 40
_TAG_BITS = 87


@dataclass(frozen=True)
class Salt:
    """A secret from which all of a suite follows.

    Attributes:
        secret: SALT_BYTES bytes; never shown.
    """

    secret: bytes = field(repr=False)

    def __post_init__(self) -> None:
        if len(self.secret) != SALT_BYTES:
            raise ValueError(f"A salt has {SALT_BYTES} bytes, not {len(self.secret)}.")

    @staticmethod
    def drawn() -> Salt:
        """A new one, from the system's own randomness."""
        return Salt(secrets.token_bytes(SALT_BYTES))

    @property
    def commitment(self) -> str:
        """What may be published before: it fits no other salt, and tells nothing of this one."""
        return hashlib.sha256(_COMMITTED + self.secret).hexdigest()

    def keyed(self, *purpose: str | int) -> bytes:
        """32 bytes that depend on the salt and the purpose (HMAC-SHA256)."""
        text = "\0".join(str(part) for part in purpose)
        return hmac.digest(self.secret, text.encode(), "sha256")

    def number(self, *purpose: str | int) -> int:
        """A number of 128 bits, too wide to be found by trying."""
        return int.from_bytes(self.keyed(*purpose)[:_NUMBER_BYTES], "big")

    def generator(self, *purpose: str | int) -> np.random.Generator:
        """A generator for this purpose alone."""
        return np.random.default_rng(self.number(*purpose))

    def seal(self, value: int, purpose: str) -> int:
        """A seed from PRIVATE_FROM on, of 128 bits, that only this salt leads from to a value.

        As in synthetic initialisation vectors (RFC 5297): a keyed hash of the value, then the
        value hidden by a keyed hash of that.

        Raises:
            ValueError: The value is negative or has over 40 bits.
        """
        if not 0 <= value < 1 << _SEALED_BITS:
            raise ValueError(f"{value} is no number of {_SEALED_BITS} bits.")
        tag = self.number("tag", purpose, value) % (1 << _TAG_BITS)
        return PRIVATE_FROM | tag << _SEALED_BITS | value ^ self._mask(tag, purpose)

    def unseal(self, sealed: int, purpose: str) -> int | None:
        """The value that was sealed; None if this salt didn't seal it for this purpose."""
        if not PRIVATE_FROM <= sealed < 2 * PRIVATE_FROM:
            return None
        tag = (sealed >> _SEALED_BITS) % (1 << _TAG_BITS)
        value = sealed % (1 << _SEALED_BITS) ^ self._mask(tag, purpose)
        return value if self.seal(value, purpose) == sealed else None

    def _mask(self, tag: int, purpose: str) -> int:
        return self.number("mask", purpose, tag) % (1 << _SEALED_BITS)
