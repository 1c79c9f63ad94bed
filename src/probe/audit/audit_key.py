"""The key of whoever audits here, by which an audit that was made elsewhere is known as such."""

from __future__ import annotations

import hmac
import re
import secrets
from pathlib import Path

from probe.errors import BadData
from probe.files import write_secret

KEY_BYTES = 32

_SEALED = b"PROBE audit, version 1\0"
_TEXT = re.compile(rf"[0-9a-f]{{{2 * KEY_BYTES}}}\n")
_REMEDY = "Delete it; a new one is made, and folders are audited again"


def key_of(path: Path) -> bytes | None:
    """The key in a file; None if there is none.

    Raises:
        BadData: The file can't be read, or holds no key.
    """
    try:
        text = path.read_text("ascii")
    except FileNotFoundError:
        return None
    except (OSError, UnicodeDecodeError) as error:
        raise BadData(path, str(error), _REMEDY) from error
    if not _TEXT.fullmatch(text):
        raise BadData(path, "holds no key of audits", _REMEDY)
    return bytes.fromhex(text)


def ready_key(path: Path) -> bytes:
    """The key in a file, which is drawn by the system's own randomness if there is none yet.

    Raises:
        BadData: As key_of().
        OutputFailed: It can't be written.
    """
    if not path.exists():
        write_secret(path, secrets.token_hex(KEY_BYTES) + "\n")
    found = key_of(path)
    assert found is not None
    return found


def seal_of(key: bytes, text: bytes) -> str:
    """What only who has the key can say of a text: HMAC-SHA256, 64 hex digits."""
    return hmac.new(key, _SEALED + text, "sha256").hexdigest()


def is_sealed(key: bytes | None, text: bytes, seal: str) -> bool:
    """Whether a seal was made of a text with this key; nothing is without one."""
    return key is not None and hmac.compare_digest(seal_of(key, text).encode(), seal.encode())
