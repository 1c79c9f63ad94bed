"""Where a suite's salt lies while it is built, and afterwards, when it is published."""

from __future__ import annotations

from pathlib import Path
from typing import Literal

import pydantic

from probe.errors import BadData
from probe.files import read_document, write_secret
from probe.generation.build_folder import BuildFolder
from probe.generation.salt import SALT_BYTES, Salt

SALT = "salt.json"
_CARRY = f"Copy {SALT} here from the folder where the suite was begun"


class SaltDocument(pydantic.BaseModel, extra="forbid"):
    """A salt, as 64 hex digits."""

    version: Literal[1] = 1
    salt: str = pydantic.Field(pattern=rf"^[0-9a-f]{{{2 * SALT_BYTES}}}$")


def read_salt(path: Path, remedy: str) -> Salt:
    """Read a salt.

    Raises:
        BadData: The file is missing or holds none; the message ends with the remedy.
    """
    document = read_document(path, SaltDocument, remedy, missing=remedy)
    return Salt(bytes.fromhex(document.salt))


def salt_of(parts: BuildFolder, *, public: bool) -> Salt | None:
    """The salt of a folder, drawn if nothing was begun there; None for a public suite.

    All who work on a folder get the same one, however many begin at once.

    Raises:
        BadData: The folder was begun in the other way, or its salt is missing or another.
        OutputFailed: The folder can't be written.
    """
    path, begun = parts.folder / SALT, parts.making()
    if public:
        if path.exists() or (begun and begun.commitment):
            reason = "a private suite was begun here"
            raise BadData(parts.folder, reason, "Leave out --public, or build into another file")
        return None
    if begun is None:
        document = SaltDocument(salt=Salt.drawn().secret.hex())
        write_secret(path, document.model_dump_json(indent=1) + "\n")
    elif begun.commitment is None:
        reason = "a public suite was begun here"
        raise BadData(parts.folder, reason, "Say --public, or build into another file")
    salt = read_salt(path, _CARRY)
    if begun and begun.commitment != salt.commitment:
        raise BadData(path, "isn't the salt that this folder was begun with", _CARRY)
    return salt
